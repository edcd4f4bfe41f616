// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/Contour.h"
#include "Core/Contour/ElementContour.h"

namespace pixelexact
{
/// A piece of a line in an element.
struct PlacedPiece
{
  int element = -1;
  CurvePiece piece;
  bool complete = false; ///< of the element: no piece is missing
};

/// Joins pieces of one value whose ends coincide, within 1e-7 of their elements' sizes, the nearest
/// first, and appends the lines. Their common points become one vertex, that of the piece which
/// comes first. Ends that meet none, and are not on a face behind which the mesh ends or at a clip,
/// are counted as inside; ends that meet several make their lines uncertified.
void AssembleLines(const Mesh& mesh, const FaceTable& faces, std::vector<PlacedPiece> pieces,
  std::size_t value, ContourSet& set);
} // namespace pixelexact
