// SPDX-License-Identifier: BSD-3-Clause
#ifndef LineBreaks_h
#define LineBreaks_h

#include "HighOrderModel.h"

#include <vector>

namespace pixelexact
{
/// Where a segment passes from one element into another, or out of the mesh: pairs of parameters of
/// start + t (end - start), ascending, between which the element changes, as near to each other as
/// roundings of t let them be. The element at each of `places` (ascending, from 0 to 1) is found
/// first; an element that lies between two places and holds neither may be passed over, and so may
/// a gap.
std::vector<double> LineBreaks(const HighOrderModel& model, const Vec3& start, const Vec3& end,
  const std::vector<double>& places);
} // namespace pixelexact
#endif
