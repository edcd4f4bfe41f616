// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Nearest.h"

#include <algorithm>
#include <numeric>

namespace pixelexact
{
namespace
{
/// The edit distance: the number of letters to replace, insert or remove.
std::size_t Distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{ 0 });
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ row[j] + 1, row[j - 1] + 1, changed });
    }
  }
  return row.back();
}
} // namespace

std::string NearestOf(const std::vector<std::string>& names, const std::string& word)
{
  std::string nearest;
  std::size_t least = word.size() / 3 + 1;
  for (const std::string& name : names)
  {
    const std::size_t distance =
      word.size() > 3 && name.starts_with(word) ? 0 : Distance(name, word);
    if (distance < least)
    {
      least = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::string Suggestion(const std::vector<std::string>& names, const std::string& word)
{
  const std::string nearest = NearestOf(names, word);
  return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
}
} // namespace pixelexact
