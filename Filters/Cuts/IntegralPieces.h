// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntegralPieces_h
#define IntegralPieces_h

#include "PixelExactFiltersModule.h"

#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrate.h"

#include <span>
#include <vector>

class vtkImplicitFunction;

namespace pixelexact
{
class HighOrderModel;

/// What integrals are taken over for the zeros of a function: PatchesOf, with pairs of parallel
/// planes as planes. Throws Unsupported for other functions, naming those that are taken;
/// InvalidData as PatchesOf.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<SurfacePatch> IntegralPatchesOf(
  vtkImplicitFunction* function);
/// The same of any surface's parts.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<SurfacePatch> IntegralPatchesOf(
  const std::vector<SurfacePatch>& patches);
/// A function that clips: what counts is where it is not positive. Throws as IntegralPatchesOf.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<ImplicitPolynomial> IntegralClipsOf(
  vtkImplicitFunction* function);

/// The sum over the parts, each clipped further. `question`: its mesh is the model's; its cut,
/// clips and box are not looked at.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT SurfaceIntegral IntegratePatches(
  const IntegralQuestion& question, std::span<const SurfacePatch> patches,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model,
  const IntegralEffort& effort);
} // namespace pixelexact
#endif
