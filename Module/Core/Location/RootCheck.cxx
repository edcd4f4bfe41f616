// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/RootCheck.h"

#include "Core/Location/PointKernels.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
void RootChecker::Run(
  std::span<const Vec3> xi, std::span<const Vec3> y, std::span<RootCheck> checks, double mostMiss)
{
  const int count = static_cast<int>(xi.size());
  for (int k = 0; k < PaddedCount(count); ++k)
  {
    const std::size_t from = std::min(static_cast<std::size_t>(k), xi.size() - 1);
    for (int d = 0; d < 3; ++d)
    {
      Lanes[static_cast<std::size_t>(d)][static_cast<std::size_t>(k)] = xi[from][d];
      Lanes[15 + static_cast<std::size_t>(d)][static_cast<std::size_t>(k)] = y[from][d];
    }
  }
  double* at[18];
  for (std::size_t k = 0; k < 18; ++k)
  {
    at[k] = Lanes[k].data();
  }
  KernelsFor(Problem.space)
    .gradient(
      Problem.space, Problem.coefficients, 3, { { at[0], at[1], at[2] }, count }, at + 3, at + 6);
  const std::uint64_t holds = CheckImages(Problem, mostMiss, count, at + 3, at + 15, at);
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    checks[k] = { Vec3(Lanes[0][k], Lanes[1][k], Lanes[2][k]), (holds >> k & 1U) != 0 };
  }
}

bool IsOnFace(const InverseProblem& problem, const Vec3& xi)
{
  RootCheck check;
  RootChecker(problem).Run(std::span(&xi, 1), std::span(&xi, 1), std::span(&check, 1));
  return check.IsOnFace(problem.space.shape, xi);
}

bool IsOnShell(const InverseProblem& problem, const Vec3& xi)
{
  RootCheck check;
  RootChecker(problem).Run(std::span(&xi, 1), std::span(&xi, 1), std::span(&check, 1));
  const Shape shape = problem.space.shape;
  const ShapeFace face = FacesOf(shape)[static_cast<std::size_t>(ShellFace(shape))];
  return std::fabs(xi[face.direction] - (face.upper ? 1.0 : -1.0)) <=
    kMaxMiss * (check.tolerance.x + check.tolerance.y + check.tolerance.z);
}
} // namespace pixelexact
