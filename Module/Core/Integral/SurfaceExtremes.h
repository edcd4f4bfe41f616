// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Integral/Integrate.h"
#include "Core/Location/Extremes.h"

#include <span>

namespace pixelexact
{
/// The extremes of a scalar over a surface in a mesh.
struct SurfaceExtremes
{
  /// Places, values and bounds as over a mesh; `notFinite` counts elements of the mesh, or faces;
  /// `unbounded` those that meet the surface and have no bound.
  Extremes extremes;
  std::int64_t elements = 0; ///< that the surface meets, as far as is known
  std::int64_t faces = 0;    ///< of elements that lie in the surface, or were asked for
  std::int64_t tooHigh = 0;  ///< as in SurfaceIntegral
  std::int64_t flat = 0;
  bool isNumeric = false; ///< the field has no models: all bounds are estimates

  /// The extremes of both surfaces together.
  void Add(const SurfaceExtremes& other);
};

/// The largest gap relative to the range of values, and the largest number of boxes an element.
inline constexpr RangeEffort kSurfaceExtremeEffort{ 1e-6, 20000 };

/// The minimum and the maximum of the question's field over the part of its cut in a mesh. The cut
/// is parametrised on boxes as for integrals, and the field there is a ChebyshevModel, whose range
/// bounds the field and whose values, less the error, are attained. Boxes in which the surface is
/// not known count with the field's range over the whole box. A box is subdivided while its bound
/// exceeds the attained range by more than the gap: `effort.tolerance` times that range, or 2^-40
/// of the largest magnitude.
///
/// `component`: of the field, or FieldFunction::kNorm for the Euclidean norm of all. Faces that lie
/// in the surface within the mesh's uncertainty count. The locator and the faces are the mesh's.
/// Parallel; the result is independent of the number of threads. Throws Unsupported as
/// IntegrateCut.
SurfaceExtremes FindExtremesOnCut(const IntegralQuestion& question, int component,
  const Locator& locator, const FaceTable& faces,
  const RangeEffort& effort = kSurfaceExtremeEffort);

/// The same over faces of elements; the question's cut is ignored.
SurfaceExtremes FindExtremesOnFaces(const IntegralQuestion& question, int component,
  std::span<const ElementFace> faces, const RangeEffort& effort = kSurfaceExtremeEffort);
} // namespace pixelexact
