// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Core/Math/Mat.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"

#include <vector>

namespace pixelexact
{
/// The affine map from a face to the same face of another element, in xi. Faces in xi are
/// parallelograms and triangles, so the map is affine.
struct AcrossFace
{
  std::int32_t element = -1; ///< the other element; -1: there is none
  Vec3 from{ 0.0 };
  Vec3 to{ 0.0 };
  Mat3 turn{ 0.0 };

  [[nodiscard]] Vec3 At(const Vec3& xi) const { return to + turn * (xi - from); }
};

/// Faces between elements on which walls of an iso-surface may lie (JumpWalls). The value lies in
/// the hull of the certified ranges of the elements on both sides. Both sides' values differ, at
/// Gauss points that determine polynomials, by more than 1e-12 of the largest magnitude in these
/// ranges. If two elements have the same face, only that of the lower element is included. Faces
/// that meet several others, or cover a part of one, are all included. In order. Parallel; the
/// result does not depend on the number of threads.
struct JumpFaces
{
  JumpFaces(const Locator& locator, const FaceTable& table, const CurvedEquation& equation);

  std::vector<CurvedPart> parts;
  std::vector<AcrossFace> across; ///< by part
};
} // namespace pixelexact
