// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceNumbers.h"
#include "Trace/Compare/LinearSurface.h"

#include <cstddef>
#include <span>

namespace pixelexact
{
/// How many triangles TrianglesOfFaces makes.
[[nodiscard]] std::size_t CountTriangles(
  const Mesh& mesh, std::span<const ElementFace> faces, int parts);

/// Faces of elements as triangles with values at their corners, what cutting elements into linear
/// cells leaves of them: each edge in `parts` parts, at least 1; quadrilaterals become 2 parts^2
/// triangles, triangles parts^2. Corners and values are exact, up to rounding, of `component`, or
/// kMagnitude. Parallel.
[[nodiscard]] LinearSurface TrianglesOfFaces(const Mesh& mesh, const Field& field, int component,
  std::span<const ElementFace> faces, int parts);
} // namespace pixelexact
