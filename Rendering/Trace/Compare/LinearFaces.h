// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Trace/Compare/LinearSurface.h"

#include <cstddef>
#include <span>

namespace pixelexact
{
/// Count of the triangles of TrianglesOfFaces.
[[nodiscard]] std::size_t CountTriangles(
  const Mesh& mesh, std::span<const ElementFace> faces, int parts);

/// Triangulates faces of elements, with values at corners, as cutting elements into linear cells
/// does. Each edge is divided into `parts` parts, at least 1; quadrilaterals become 2 parts^2
/// triangles, triangles parts^2. Corners and values of `component`, or kMagnitude, are exact up to
/// rounding. Parallel.
[[nodiscard]] LinearSurface TrianglesOfFaces(const Mesh& mesh, const Field& field, int component,
  std::span<const ElementFace> faces, int parts);
} // namespace pixelexact
