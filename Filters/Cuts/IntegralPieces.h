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

/// The surface patches of integrals over a function's zeros: PatchesOf, with pairs of parallel
/// planes as planes. Throws Unsupported for other functions, naming the supported ones; InvalidData
/// as PatchesOf.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<SurfacePatch> IntegralPatchesOf(
  vtkImplicitFunction* function);
/// The same of any surface's parts.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<SurfacePatch> IntegralPatchesOf(
  const std::vector<SurfacePatch>& patches);
/// A function that clips: what counts is where it is not positive. Throws as IntegralPatchesOf.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<ImplicitPolynomial> IntegralClipsOf(
  vtkImplicitFunction* function);

/// The sum of the integrals over the patches, each clipped by `clips` as well. `question`: its mesh
/// must be the model's; its cut, clips and box are ignored, `below` counts.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT SurfaceIntegral IntegratePatches(
  const IntegralQuestion& question, std::span<const SurfacePatch> patches,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model,
  const IntegralEffort& effort);
} // namespace pixelexact
#endif
