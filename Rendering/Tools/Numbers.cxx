// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"

#include <charconv>

namespace pixelexact
{
namespace
{
template <class Number>
bool ParseWhole(std::string_view text, Number& number)
{
  const char* end = text.data() + text.size();
  const auto [last, failure] = std::from_chars(text.data(), end, number);
  return failure == std::errc() && last == end;
}
} // namespace

std::string_view Trim(std::string_view text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool ParseNumber(std::string_view text, double& number)
{
  text = Trim(text);
  // from_chars, which knows no locale, does not know a plus sign either.
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
  {
    text.remove_prefix(1);
  }
  return !text.empty() && ParseWhole(text, number);
}

bool ParseInteger(std::string_view text, int& number)
{
  return ParseWhole(text, number);
}
} // namespace pixelexact
