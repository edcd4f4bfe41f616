// SPDX-License-Identifier: BSD-3-Clause
#include "Base/RepeatedCommand.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace pixelexact
{
namespace
{
/// As a shell reads it.
std::string Quoted(const std::string& word)
{
  constexpr std::string_view kPlain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
    "_-./,=:%+@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos)
  {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}
} // namespace

std::vector<std::string> RepeatedCommand::Words() const
{
  std::vector<std::string> words{ "pixelexact" };
  words.insert(words.end(), given.begin(), given.end());
  // What follows "--" is no option.
  words.insert(std::ranges::find(words, "--"), chosen.begin(), chosen.end());
  return words;
}

std::string RepeatedCommand::Text() const
{
  std::vector<std::string> words = Words();
  std::ranges::transform(words, words.begin(), Quoted);
  return fmt::format("{}", fmt::join(words, " "));
}
} // namespace pixelexact
