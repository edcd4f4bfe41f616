// SPDX-License-Identifier: BSD-3-Clause
#include "MessageWords.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
std::vector<MessageWord>& Words()
{
  static std::vector<MessageWord> words;
  return words;
}
} // namespace

void SetMessageWords(std::vector<MessageWord> words)
{
  Words() = std::move(words);
}

std::string Worded(const std::string& text)
{
  std::string worded;
  worded.reserve(text.size());
  for (std::size_t at = 0; at < text.size();)
  {
    const auto found = std::ranges::find_if(Words(),
      [&](const MessageWord& word) { return text.compare(at, word.name.size(), word.name) == 0; });
    if (found == Words().end())
    {
      worded += text[at++];
    }
    else
    {
      worded += found->word;
      at += found->name.size();
    }
  }
  return worded;
}
} // namespace pixelexact
