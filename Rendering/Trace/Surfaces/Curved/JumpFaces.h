// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Core/Math/Mat.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"

#include <vector>

namespace pixelexact
{
/// Of a face that is one with another element's: its points in xi there. Faces in xi are
/// parallelograms and triangles, so that the way is affine.
struct AcrossFace
{
  std::int32_t element = -1; ///< none: no such face
  Vec3 from{ 0.0 };
  Vec3 to{ 0.0 };
  Mat3 turn{ 0.0 };

  [[nodiscard]] Vec3 At(const Vec3& xi) const { return to + turn * (xi - from); }
};

/// Faces between elements on which walls of an iso-surface may be (JumpWalls): the value lies in
/// what the certified ranges of the elements on both sides span, and both sides' values differ at
/// Gauss points that tell polynomials apart, by more than 1e-12 of these ranges' largest number.
/// Of two faces that are one, that of the lower element; of faces that meet several others, or
/// cover a part of one, all. In order. Parallel; the same for any number of threads.
struct JumpFaces
{
  JumpFaces(const Locator& locator, const FaceTable& table, const CurvedEquation& equation);

  std::vector<CurvedPart> parts;
  std::vector<AcrossFace> across; ///< by part
};
} // namespace pixelexact
