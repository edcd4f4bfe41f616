// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Index/ValueIndex.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace pixelexact
{
ValueIndex::ValueIndex(const Mesh& mesh, const RangeQuestion& question, int boxes)
  : Ranges(static_cast<std::size_t>(mesh.Elements()))
  , Whole{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() }
{
  // A range that is a tenth too wide costs less than a tighter one.
  const RangeEffort effort{ 0.1, boxes };
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e)
    {
      const Interval range = pixelexact::RangeOf(mesh, e, question, effort).outer;
      const bool known = range.lower <= range.upper;
      Ranges[static_cast<std::size_t>(e)] = known ? range : Interval::Everything();
    });
  for (const Interval& range : Ranges)
  {
    Whole = { std::min(Whole.lower, range.lower), std::max(Whole.upper, range.upper) };
  }
}

void ValueIndex::Find(const Interval& values, std::vector<int>& elements) const
{
  elements.clear();
  // Takes a millisecond for a million elements; a tree would save little.
  for (std::size_t e = 0; e < Ranges.size(); ++e)
  {
    if (Ranges[e].lower <= values.upper && values.lower <= Ranges[e].upper)
    {
      elements.push_back(static_cast<int>(e));
    }
  }
}
} // namespace pixelexact
