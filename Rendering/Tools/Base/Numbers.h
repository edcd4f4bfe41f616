// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

// Reading of numbers, in the C locale.
namespace pixelexact
{
/// Without the blanks and tabs around it.
std::string_view Trim(std::string_view text);

/// The number that the whole of `text` spells, blanks around it aside; no number: false.
[[nodiscard]] bool ParseNumber(std::string_view text, double& number);

/// The integer that the whole of `text` spells, with neither blanks nor a plus sign; none: false.
[[nodiscard]] bool ParseInteger(std::string_view text, int& number);
} // namespace pixelexact
