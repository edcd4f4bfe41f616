// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/ApexRoot.h"

#include "Core/Math/Norm.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
const Vec3 kApex(-1.0, -1.0, 1.0);
/// The accepted miss at the apex, where no better xi exists: kMaxMiss for each of the elements that
/// meet there, and their rounding.
constexpr double kMaxMissAtApex = 16.0;

double LargestSlack(const NodeFrame& frame)
{
  return std::max({ frame.slack[0], frame.slack[1], frame.slack[2] });
}

RootCheck Check(RootChecker& checker, const Vec3& xi, const Vec3& y, double mostMiss = kMaxMiss)
{
  RootCheck check;
  checker.Run(std::span(&xi, 1), std::span(&y, 1), std::span(&check, 1), mostMiss);
  return check;
}
} // namespace

bool IsAtApex(Shape shape, const NodeFrame& frame)
{
  // Where the base is collapsed, rounding may be as large as a box.
  constexpr double kLargest = 1e-3;
  const double depth = 1.0 - frame.box.lower.z;
  return shape == Shape::Pyramid && frame.IsAffine() &&
    (depth <= kApexRegion ||
      (frame.box.upper.z == 1.0 && depth <= std::min(4.0 * LargestSlack(frame), kLargest)));
}

ApexRoot RootAtApex(
  const InverseProblem& problem, RootChecker& checker, const NodeFrame& frame, const Vec3& y)
{
  const Vec3 middle = frame.Root(y);
  Vec3 root = middle;
  Vec3 xi(0.0);
  constexpr int kSteps = 4;
  for (int step = 0; step < kSteps; ++step)
  {
    const double z = std::clamp(root.z, -1.0, 1.0);
    xi = { std::clamp(root.x, -1.0, -z), std::clamp(root.y, -1.0, -z), z };
    root = xi + StepOfMap(problem.space, problem.coefficients, xi, y);
  }
  RootCheck check = Check(checker, xi, y);
  constexpr double kBeside = 4.0;
  for (int d = 0; d < 3; ++d)
  {
    check.holds = check.holds &&
      std::fabs(xi[d] - middle[d]) <= kBeside * frame.slack[static_cast<std::size_t>(d)];
  }
  // At the apex itself no Jacobian distinguishes directions; the box's is as good as any.
  if (!check.holds && MaxAbs(middle - kApex) <= kBeside * LargestSlack(frame))
  {
    xi = kApex;
    root = middle;
    check = Check(checker, xi, y, kMaxMissAtApex);
  }
  return { xi, MaxAbs(root - xi), check };
}
} // namespace pixelexact
