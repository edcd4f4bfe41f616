// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/FoundRoots.h"

#include "Core/Math/Norm.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Roots nearer to each other than this, in a region where there can be but one, are one.
constexpr double kSameRoot = 1e-12;
} // namespace

void FoundRoots::Add(std::size_t point, const InverseRoot& root, const RootCheck& check)
{
  // Two runs of the iteration to one root differ by rounding.
  constexpr double kTolerances = 4.0;
  if ((check.holds || !root.inside) && !IsKnown(point, root.xi, root.inside, check, kTolerances))
  {
    Keep(point, root, check);
  }
}

void FoundRoots::Keep(std::size_t point, const InverseRoot& root, const RootCheck& check)
{
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<InverseRoot>& found = Roots[point];
  const std::size_t slot = found.size();
  found.push_back(root);
  if (InLanes.size() <= slot)
  {
    GroupRoots& none = InLanes.emplace_back();
    std::fill_n(none.tolerance, kGroupPoints, kNan);
  }
  GroupRoots& lanes = InLanes[slot];
  for (int d = 0; d < 3; ++d)
  {
    lanes.xi.x[d][point] = root.xi[d];
  }
  // The true root must be in the reach. Its place is unknown if its Jacobian is singular, or the
  // map does not take it to the point.
  const double error = MaxAbs(check.tolerance);
  lanes.tolerance[point] =
    error > 0.0 && check.holds ? kSameRoot - std::max(error - kSameRoot, 0.0) : kNan;
  if (root.inside && !All)
  {
    WithEnough |= BitOf(point);
  }
}

bool FoundRoots::IsKnown(
  std::size_t point, const Vec3& xi, bool inside, const RootCheck& check, double tolerances) const
{
  const Vec3 distance = tolerances * check.tolerance + Vec3(kSameRoot);
  return std::ranges::any_of(Roots[point],
    [&](const InverseRoot& known)
    {
      const Vec3 apart = glm::abs(known.xi - xi);
      return apart.x <= distance.x && apart.y <= distance.y && apart.z <= distance.z &&
        known.inside == inside;
    });
}

bool FoundRoots::IsAll(const Box3& box, std::size_t point) const
{
  return std::ranges::any_of(Roots[point],
    [&](const InverseRoot& root)
    { return std::max(MaxAbs(box.lower - root.xi), MaxAbs(box.upper - root.xi)) <= kSameRoot; });
}
} // namespace pixelexact
