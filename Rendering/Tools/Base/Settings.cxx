// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Settings.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

constexpr Setting kSettings[] = {
#include "SettingRows.inc"
};
} // namespace

std::string_view Setting::LongName() const
{
  return names.substr(names.find(',') + 1); // npos + 1 is 0
}

std::span<const Setting> Settings()
{
  return kSettings;
}

const Setting* FindSetting(std::string_view command, std::string_view name)
{
  const auto* const found = std::ranges::find_if(kSettings,
    [&](const Setting& row) { return row.LongName() == name && HasWord(row.commands, command); });
  return found != std::end(kSettings) ? found : nullptr;
}

std::vector<std::string> WordsIn(std::string_view list)
{
  std::vector<std::string> words;
  while (!list.empty())
  {
    const auto blank = std::min(list.find(' '), list.size());
    words.emplace_back(list.substr(0, blank));
    list.remove_prefix(std::min(blank + 1, list.size()));
  }
  return words;
}

bool HasWord(std::string_view list, std::string_view word)
{
  for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1))
  {
    const std::size_t end = at + word.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' '))
    {
      return true;
    }
  }
  return false;
}
} // namespace pixelexact
