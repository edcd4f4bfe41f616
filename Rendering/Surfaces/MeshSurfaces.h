// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// Cut-surfaces that are made of a model's mesh and fields, for mappers and the tool. They keep the
// model alive.
namespace pixelexact
{
class HighOrderModel;

/// Faces of elements; neither attributes nor elements: the boundary of the mesh, where a face that
/// is partly covered counts as far as nothing lies behind it.
struct BoundaryChoice
{
  std::vector<int> attributes; ///< of the boundary, as the solver numbers its parts
  /// All faces of these elements, by the numbers of their source cells; of composite data those of
  /// every block.
  std::vector<std::int64_t> elements;

  bool operator==(const BoundaryChoice&) const = default;
};

/// Throws Error where the mesh has no such element or attribute.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> MakeBoundary(
  const std::shared_ptr<const HighOrderModel>& model, const BoundaryChoice& choice);

/// Where a component of a field has a value.
struct IsoChoice
{
  std::string field;          ///< empty: the first one
  int component = kMagnitude; ///< of a scalar: itself
  double value = 0.0;
  bool mayBeEmpty = false; ///< no element has to hold a value that the field as a whole may have
};

/// For an expression, of which nothing is known but its values, it is a SearchedSurface.
/// Throws Error for a field or component that is not there, and for a value that the field is
/// proven not to have, naming its range, or that is not finite; Unsupported for
/// mapped fields.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> MakeIsoSurface(
  const std::shared_ptr<const HighOrderModel>& model, const IsoChoice& choice);

/// What such a surface lacks where the field jumps between elements (JumpWalls); nowhere, perhaps.
/// Throws as MakeIsoSurface does.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> MakeJumpWalls(
  const std::shared_ptr<const HighOrderModel>& model, const IsoChoice& choice);
} // namespace pixelexact
