// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Location/RootCheck.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Location/RootCheck.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Stores the tolerances at `count` points; returns those at which Phi is y. `phi`: three
/// coordinates and their nine derivatives.
std::uint64_t CheckImages(const InverseProblem& problem, double mostMiss, int count,
  const double* const phi[12], const double* const y[3], double* const to[3])
{
  const Lanes zero = Splat(0.0);
  std::uint64_t holds = 0;
  for (int i = 0; i < count; i += LaneCount())
  {
    LaneMask hold = zero <= zero;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Lanes miss =
        NumberTraits<Lanes>::Load(phi[c] + i) - NumberTraits<Lanes>::Load(y[c] + i);
      hold = And(hold, Abs(miss) <= Splat(mostMiss * problem.uncertainty[c]));
    }
    holds |= BitsOf(hold) << static_cast<unsigned>(i);
    Matrix<Lanes> jacobian;
    for (std::size_t k = 0; k < 9; ++k)
    {
      jacobian.m[k] = NumberTraits<Lanes>::Load(phi[3 + k] + i);
    }
    const Point<Lanes> tolerance = ToleranceOf(Inverse(jacobian), problem.uncertainty);
    const LaneMask regular = IsFinite(tolerance.x[0] + tolerance.x[1] + tolerance.x[2]);
    for (std::size_t d = 0; d < 3; ++d)
    {
      Store(Select(regular, tolerance.x[d], zero), to[d] + i);
    }
  }
  return holds;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(CheckImages);

void RootChecker::Run(
  std::span<const Vec3> xi, std::span<const Vec3> y, std::span<RootCheck> checks, double mostMiss)
{
  const int count = static_cast<int>(xi.size());
  for (int k = 0; k < PaddedCount(count); ++k)
  {
    const auto from = static_cast<std::size_t>(std::min(k, count - 1));
    for (int d = 0; d < 3; ++d)
    {
      Lanes[static_cast<std::size_t>(d)][static_cast<std::size_t>(k)] = xi[from][d];
      Lanes[static_cast<std::size_t>(15 + d)][static_cast<std::size_t>(k)] = y[from][d];
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
  const std::uint64_t holds =
    HWY_DYNAMIC_DISPATCH(CheckImages)(Problem, mostMiss, count, at + 3, at + 15, at);
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
} // namespace pixelexact
#endif
