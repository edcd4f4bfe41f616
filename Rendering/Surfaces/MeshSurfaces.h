// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// Cut-surfaces of a model's mesh and fields, for mappers and the tool. They keep the model alive.
namespace pixelexact
{
class HighOrderModel;

/// A choice of elements' faces. Without any choice, it is the boundary of the mesh, including the
/// uncovered parts of partly covered faces.
struct BoundaryChoice
{
  std::vector<int> attributes; ///< of the boundary, as numbered by the solver
  /// All faces of these elements, by the numbers of their source cells; for composite data, those
  /// of every block.
  std::vector<std::int64_t> elements;
  /// The faces between elements: once where whole faces meet, with the values of the element with
  /// the lower number. Hanging faces are there from both sides; faces that others cover in part are
  /// left out.
  bool inner = false;

  bool operator==(const BoundaryChoice&) const = default;
};

/// Throws Error if the mesh lacks an element or attribute, or has no face between elements.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> MakeBoundary(
  const std::shared_ptr<const HighOrderModel>& model, const BoundaryChoice& choice);

/// The points where a field's component has a value.
struct IsoChoice
{
  std::string field;          ///< empty: the first field
  int component = kMagnitude; ///< for a scalar field: the signed value
  double value = 0.0;
  bool mayBeEmpty = false; ///< no single element has to take the value
};

/// For an expression without polynomial form, a SearchedSurface. Throws Error for a field or
/// component that does not exist, for a value that is not finite, and for a value that the field is
/// proven not to take; the message names the field's range. Throws Unsupported for mapped fields.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> MakeIsoSurface(
  const std::shared_ptr<const HighOrderModel>& model, const IsoChoice& choice);

/// The walls of an iso-surface where the field jumps between elements (JumpWalls); may be empty.
/// Throws as MakeIsoSurface does.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> MakeJumpWalls(
  const std::shared_ptr<const HighOrderModel>& model, const IsoChoice& choice);
} // namespace pixelexact
