// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

// Reading of numbers, in the C locale, and what people are shown of them.
namespace pixelexact
{
/// The text without blanks and tabs at its ends.
std::string_view Trim(std::string_view text);

/// The number that the whole of `text` spells, blanks around it aside; no number: false.
[[nodiscard]] bool ParseNumber(std::string_view text, double& number);

/// The integer that the whole of `text` spells, with neither blanks nor a plus sign; none: false.
[[nodiscard]] bool ParseInteger(std::string_view text, int& number);

/// Returns 0 for a number below 1e-14 of `size`, which is a rounding error among numbers of that
/// size, and for -0. For tables and printed command lines.
[[nodiscard]] double WithoutRoundings(double number, double size);
} // namespace pixelexact
