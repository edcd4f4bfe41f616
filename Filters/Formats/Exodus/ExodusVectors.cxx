// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Exodus/ExodusVectors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>

namespace pixelexact
{
namespace
{
using Endings = std::span<const std::string_view>;
constexpr std::array<std::string_view, 2> kPlane{ "x", "y" };
constexpr std::array<std::string_view, 3> kSpace{ "x", "y", "z" };
constexpr std::array<std::string_view, 2> kAxial{ "r", "z" };
constexpr std::array<std::string_view, 6> kTensor{ "xx", "yy", "zz", "xy", "xz", "yz" };

/// Whether a name is that beginning with that ending.
bool Is(const std::string& name, std::string_view begin, std::string_view ending)
{
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return name.size() == begin.size() + ending.size() && name.starts_with(begin) &&
    std::equal(ending.rbegin(), ending.rend(), name.rbegin(),
      [&](char letter, char own) { return same(own, letter); });
}

/// How many variables from `first` on are components; 0: these endings do not fit.
std::size_t CountComponents(
  const std::vector<std::string>& variables, std::size_t first, Endings endings)
{
  const std::string& name = variables[first];
  if (name.size() <= endings[0].size() || first + endings.size() > variables.size())
  {
    return 0;
  }
  const std::string_view begin(name.data(), name.size() - endings[0].size());
  for (std::size_t i = 0; i < endings.size(); ++i)
  {
    if (!Is(variables[first + i], begin, endings[i]))
    {
      return 0;
    }
  }
  return endings.size();
}
} // namespace

std::vector<ExodusField> JoinComponents(const std::vector<std::string>& variables)
{
  std::vector<ExodusField> fields;
  for (std::size_t first = 0; first < variables.size(); first += fields.back().count)
  {
    ExodusField field{ variables[first], first, 1 };
    for (const Endings endings :
      { Endings(kPlane), Endings(kSpace), Endings(kAxial), Endings(kTensor) })
    {
      const std::size_t count = CountComponents(variables, first, endings);
      if (count > field.count)
      {
        field.count = count;
        field.name = variables[first].substr(0, variables[first].size() - endings[0].size());
      }
    }
    while (std::ranges::find(fields, field.name, &ExodusField::name) != fields.end())
    {
      field.name += "_";
    }
    fields.push_back(std::move(field));
  }
  return fields;
}
} // namespace pixelexact
