// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/InverseRoot.h"

#include "Core/Location/InversionNode.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
std::optional<InverseRoot> FindInverseRoot(
  const InverseProblem& problem, const Vec3& x, const Vec3& start)
{
  InverseProblem asked = problem;
  // A frame of zero slope lets the kernel's iteration begin where we want it.
  std::fill_n(asked.inverse, 9, 0.0);
  asked.affine = false;
  asked.guess = nullptr;
  double lanes[9][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    asked.start[d] = start[d];
    std::fill_n(lanes[d], kLanePadding, x[d]);
  }
  const InverseResult result{ { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], lanes[8] };
  KernelsFor(problem.space).invert(asked, { { lanes[0], lanes[1], lanes[2] }, 1 }, result);
  if (lanes[6][0] == static_cast<double>(NewtonStatus::NotConverged))
  {
    return std::nullopt;
  }
  InverseRoot root{ { lanes[3][0], lanes[4][0], lanes[5][0] }, lanes[8][0], false, false };
  root.inside = lanes[6][0] == static_cast<double>(NewtonStatus::RootInside);
  // Beyond a pyramid's apex is another cone, whose roots say nothing of this one's.
  if (!root.inside && problem.space.shape == Shape::Pyramid && root.xi.z > 1.0)
  {
    return std::nullopt;
  }
  root.onFace = root.inside && IsOnFace(problem, root.xi);
  return root;
}

Vec3 FaceTolerance(const InverseProblem& problem, const Vec3& xi)
{
  const auto inverse = InverseJacobian(problem.space, problem.coefficients, xi);
  Vec3 tolerance(0.0);
  for (int d = 0; inverse && d < 3; ++d)
  {
    for (int c = 0; c < 3; ++c)
    {
      tolerance[d] +=
        std::fabs((*inverse)[static_cast<std::size_t>(d)][static_cast<std::size_t>(c)]) *
        problem.uncertainty[c];
    }
  }
  return tolerance;
}

bool IsOnFace(const InverseProblem& problem, const Vec3& xi)
{
  const Vec3 tolerance = FaceTolerance(problem, xi);
  return !(Margin(problem.space.shape, xi) > tolerance.x + tolerance.y + tolerance.z);
}
} // namespace pixelexact
