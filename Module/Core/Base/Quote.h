// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace pixelexact
{
/// Quotes foreign text for messages: cut to `longest` characters, because a binary file is one long
/// word, and with '?' for characters that are not printable.
inline std::string Quote(std::string_view text, std::size_t longest = 40)
{
  std::string shown(text.substr(0, longest));
  std::ranges::replace_if(
    shown, [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return "'" + shown + (text.size() > longest ? "...'" : "'");
}
} // namespace pixelexact
