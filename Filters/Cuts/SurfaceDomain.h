// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceDomain_h
#define SurfaceDomain_h

#include "PixelExactFiltersModule.h"

#include "Core/Integral/Integrate.h"
#include "Core/Integral/SurfaceExtremes.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace pixelexact
{
class HighOrderModel;
struct SurfacePatch;

/// A surface in a model's mesh over which any field is integrated.
struct SurfaceDomain
{
  /// `below`: as in IntegralQuestion.
  std::function<SurfaceIntegral(
    const Field* field, const IntegralEffort& effort, std::optional<double> below)>
    integrate;
  /// `component`: as in FindExtremesOnCut.
  std::function<SurfaceExtremes(const Field& field, int component)> extremes;
};
/// The domains of the arguments of IntegratePatches, IntegrateCut (with the question's cut and
/// clips) and IntegrateBoundary. The views must outlive the domain.
PIXELEXACTFILTERS_EXPORT SurfaceDomain DomainOfPatches(std::span<const SurfacePatch> patches,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model);
PIXELEXACTFILTERS_EXPORT SurfaceDomain DomainOfCut(
  const IntegralCut& cut, std::span<const ImplicitPolynomial> clips, const HighOrderModel& model);
PIXELEXACTFILTERS_EXPORT SurfaceDomain DomainOfBoundary(std::span<const std::int32_t> attributes,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model);
} // namespace pixelexact
#endif
