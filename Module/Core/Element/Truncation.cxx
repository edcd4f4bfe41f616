// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Truncation.h"

#include <algorithm>
#include <map>

namespace pixelexact
{
namespace
{
/// Each bound on the modes' numbers falls or stays, so the modes are a subset of the space's.
Space Lowered(const Space& space, int order)
{
  Space low = space;
  for (std::uint8_t& one : low.order)
  {
    one = std::min(one, static_cast<std::uint8_t>(order));
  }
  return low;
}

/// For each mode of `space` its number in `low`, -1 where that lacks it.
std::vector<int> NumbersIn(const Space& space, const Space& low)
{
  std::map<std::array<int, 3>, int> kept;
  ForEachMode(low, [&kept](int p, int q, int r, int mode) { kept[{ p, q, r }] = mode; });
  std::vector<int> numbers(static_cast<std::size_t>(space.Modes()), -1);
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      if (const auto at = kept.find({ p, q, r }); at != kept.end())
      {
        numbers[static_cast<std::size_t>(mode)] = at->second;
      }
    });
  return numbers;
}
} // namespace

Truncation::Truncation(const Field& field, int order)
  : Name(field.name)
  , mapping_(field.mapping)
  , order_(order)
{
  RequirePolynomials(field, "truncations");
  const Expansion& values = field.values;
  High.spaces.assign(values.spaces.begin(), values.spaces.end());
  High.spaceOf.assign(values.spaceOf.begin(), values.spaceOf.end());
  High.components = values.components;
  Low.spaceOf = High.spaceOf;
  Low.components = High.components;
  std::vector<std::vector<int>> numbers;
  for (const Space& space : values.spaces)
  {
    Low.spaces.push_back(Lowered(space, order));
    numbers.push_back(NumbersIn(space, Low.spaces.back()));
  }
  Low.Allocate();
  High.Allocate();
  for (int e = 0; e < values.Elements(); ++e)
  {
    const auto space = static_cast<std::size_t>(values.spaceOf[static_cast<std::size_t>(e)]);
    const auto modes = numbers[space].size();
    const auto kept = static_cast<std::size_t>(Low.spaces[space].Modes());
    AllModes += static_cast<std::int64_t>(modes);
    Lost += static_cast<std::int64_t>(modes - kept);
    const double* from = values.Coefficients(e);
    double* low = Low.Coefficients(static_cast<std::size_t>(e)).data();
    double* high = High.Coefficients(static_cast<std::size_t>(e)).data();
    for (int c = 0; c < values.components; ++c)
    {
      for (const int number : numbers[space])
      {
        *high++ = number < 0 ? *from : 0.0;
        if (number >= 0)
        {
          low[number] = *from;
        }
        ++from;
      }
      low += kept;
    }
  }
}

Field Truncation::Kept() const
{
  return { Name, Low.View(), mapping_ };
}

Field Truncation::Dropped() const
{
  return { Name, High.View(), mapping_ };
}

double LargestChange(
  const Mesh& mesh, const Truncation& truncation, int component, const RangeProgress& progress)
{
  if (truncation.DroppedModes() == 0)
  {
    return 0.0;
  }
  // Two digits of an error suffice.
  constexpr RangeEffort kEffort{ 1e-2, 500 };
  const Field dropped = truncation.Dropped();
  RangeQuestion question;
  question.field = &dropped;
  const bool norm = component < 0 && dropped.values.components > 1;
  question.quantity = norm ? Quantity::Magnitude : Quantity::Component;
  question.component = std::max(component, 0);
  const Interval range = RangeOf(mesh, question, kEffort, progress).range.outer;
  return range.IsEmpty() ? 0.0 : range.Magnitude();
}
} // namespace pixelexact
