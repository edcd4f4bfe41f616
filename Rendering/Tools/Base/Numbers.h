// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

// Reading of numbers, in the C locale, and what people are shown of them.
namespace pixelexact
{
/// Without the blanks and tabs around it.
std::string_view Trim(std::string_view text);

/// The number that the whole of `text` spells, blanks around it aside; no number: false.
[[nodiscard]] bool ParseNumber(std::string_view text, double& number);

/// The integer that the whole of `text` spells, with neither blanks nor a plus sign; none: false.
[[nodiscard]] bool ParseInteger(std::string_view text, int& number);

/// For tables and printed command lines: 0 in place of a number below 1e-14 of `size`, which
/// roundings among numbers of that size leave where 0 is meant. Also 0 in place of -0.
[[nodiscard]] double WithoutRoundings(double number, double size);
} // namespace pixelexact
