// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"

#include <vector>

namespace pixelexact
{
/// Faces between elements on which walls of an iso-surface may be (JumpWalls): the value lies in
/// what the certified ranges of the elements on both sides span, and both sides' values differ at
/// Gauss points that tell polynomials apart, by more than 1e-12 of these ranges' largest number.
/// Of two faces that are one, that of the lower element; of faces that meet several others, or
/// cover a part of one, all. In order. Parallel; the same for any number of threads.
struct JumpFaces
{
  JumpFaces(const Locator& locator, const FaceTable& table, const CurvedEquation& equation);

  std::vector<CurvedPart> parts;
  /// By part: how far apart the values on both sides are, at most; infinite where that is not
  /// known. Of polynomials, by their values at Gauss points.
  std::vector<double> jumps;
};
} // namespace pixelexact
