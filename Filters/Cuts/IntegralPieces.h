// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntegralPieces_h
#define IntegralPieces_h

#include "PixelExactFiltersModule.h"

#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrate.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class vtkImplicitFunction;

namespace pixelexact
{
class HighOrderModel;

/// A part of a surface that integrals are taken over.
struct IntegralPiece
{
  std::shared_ptr<const IntegralCut> cut;
  std::vector<QuadricForm> clips; ///< what counts is where none is positive
  std::optional<Box3> within;     ///< it is in this box
};

/// Planes, spheres, cylinders, cones (both halves), quadrics, vtkImplicitTorus without transform,
/// vtkBox and vtkPlanes, face by face. Throws Unsupported for other functions, naming those that
/// are taken; InvalidData as MakeCutFunction.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<IntegralPiece> PiecesOf(
  vtkImplicitFunction* function);
/// A function that clips: what counts is where it is not positive. Planes, quadrics, vtkBox and
/// vtkPlanes. Throws as PiecesOf.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<QuadricForm> ClipsOf(
  vtkImplicitFunction* function);
/// A triangle, whose flux is along the product of its first two sides; nothing where it has no
/// area.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::optional<IntegralPiece> TrianglePiece(
  const std::array<Vec3, 3>& triangle);

/// The sum over the pieces, each clipped further. `question`: its mesh is the model's; its cut,
/// clips and box are not looked at.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT SurfaceIntegral IntegratePieces(
  const IntegralQuestion& question, std::span<const IntegralPiece> pieces,
  std::span<const QuadricForm> clips, const HighOrderModel& model, const IntegralEffort& effort);
} // namespace pixelexact
#endif
