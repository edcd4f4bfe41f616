// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string_view>

namespace pixelexact
{
/// Blanks and line ends, as XML has them.
inline constexpr std::string_view kBlanks = " \t\r\n";

/// Without the blanks and line ends around it.
inline std::string_view WithoutBlanks(std::string_view text)
{
  const auto first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The number that the whole of `text` spells, in the C locale, a plus sign before it aside. False
/// where it spells none or one beyond the range of its type; `number` is then as it was.
template <class Number>
[[nodiscard]] bool ParseWhole(std::string_view text, Number& number)
{
  // from_chars does not know a plus sign.
  if (text.starts_with('+') && !text.starts_with("+-"))
  {
    text.remove_prefix(1);
  }
  Number read{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), read);
  if (failure != std::errc() || end != text.data() + text.size())
  {
    return false;
  }
  number = read;
  return true;
}
} // namespace pixelexact
