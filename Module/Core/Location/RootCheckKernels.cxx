// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Location/RootCheckKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Location/PointKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
std::uint64_t CheckAllImages(const InverseProblem& problem, double mostMiss, int count,
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
HWY_EXPORT(CheckAllImages);

std::uint64_t CheckImages(const InverseProblem& problem, double mostMiss, int count,
  const double* const phi[12], const double* const y[3], double* const tolerance[3])
{
  return HWY_DYNAMIC_DISPATCH(CheckAllImages)(problem, mostMiss, count, phi, y, tolerance);
}
} // namespace pixelexact
#endif
