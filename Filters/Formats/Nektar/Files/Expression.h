// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string_view>

namespace pixelexact::nektar
{
/// The value of a name that an expression may use, or nothing.
using NamedValue = std::function<std::optional<double>(std::string_view)>;

/// The value of a constant expression in Nektar++'s syntax (User guide, "Analytic expressions"; as
/// its Interpreter reads it): numbers, + - * / % ^, comparisons (1 or 0), parentheses, the
/// constants (PI, E, SQRT2, ...) and functions (sqrt, sin, atan2, ...) of its list, and names that
/// `parameter` knows. ^ is right-associative; a minus before a product negates all of it, one
/// before a number behind * / % ^ belongs to the number: -2^2 is -4, 3*-2^2 is 12.
///
/// Throws InvalidData for what is none, names that are not known, awgn (it is random), more than
/// 256 characters or 32 parentheses within each other, and values that are not finite.
double Evaluate(std::string_view text, const NamedValue& parameter);
} // namespace pixelexact::nektar
