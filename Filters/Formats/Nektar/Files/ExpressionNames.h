// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace pixelexact::nektar
{
/// A constant of Nektar++'s expressions, or nothing.
std::optional<double> ConstantNamed(std::string_view name);

/// The value of a function of Nektar++'s expressions, or nothing where it has none of this name and
/// so many arguments. awgn, which is random, is left out.
std::optional<double> CallFunction(std::string_view name, std::span<const double> arguments);
} // namespace pixelexact::nektar
