// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"

#include <span>

namespace pixelexact
{
/// The neighbour behind an element's face at one of its points.
struct BehindFace
{
  /// Inside: an element lies on the other side of the face. Outside: none. Unknown: some element
  /// could not be decided.
  Verdict verdict = Verdict::Outside;
  std::int32_t element = -1; ///< the lowest number, where elements overlap
  Vec3 xi{ 0.0 };            ///< where it holds the point, to first order
};

/// Finds the neighbours behind points of a face: `xi` on it, `x` their images; one entry of
/// `behind` for each. Each point is located outside the face at twice the element's own
/// uncertainty. The neighbour is another element that holds the point there within the faces'
/// tolerance, on a face that has the opposite direction. Along the rim of a neighbour the result is
/// that of a rim moved by rounding. An element that is off the face by more than the uncertainties,
/// or overlaps this element by 1e-6 of its size, is no neighbour (see
/// Documentation/curved-surfaces.md).
///
/// Serial; faster for points near each other. The result for a point depends on that point alone.
void FindBehind(const Locator& locator, const ElementFace& face, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<BehindFace> behind);

/// The same for any points of an element: `xi`, and `x`, their images. A point is on a face where
/// its distance in xi is at most 1e-9; on edges and vertices, the first face with an element behind
/// it counts. Points on no face: Outside. Serial; the result for a point depends on that point
/// alone.
void FindBehindPoints(const Locator& locator, int element, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<BehindFace> behind);
} // namespace pixelexact
