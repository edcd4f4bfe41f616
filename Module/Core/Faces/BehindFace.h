// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Faces/FaceNumbers.h"
#include "Core/Location/Locator.h"

#include <span>

namespace pixelexact
{
/// What lies behind an element's face at one of its points.
struct BehindFace
{
  /// Inside: an element does, on the other side of the face. Outside: none. Unknown: some element
  /// could not be decided.
  Verdict verdict = Verdict::Outside;
  std::int32_t element = -1; ///< the lowest number, where elements overlap
  Vec3 xi{ 0.0 };            ///< where it holds the point, to first order
};

/// Of points of a face: `xi` on it, `x` their images; one entry of `behind` for each. Each point is
/// located beyond the face by twice the element's own uncertainty: another element that holds it
/// there within the faces' tolerance, on a face that looks against this one, is behind it. So along
/// the rim of what covers a face the answer is that of a rim moved by rounding; what lies off the
/// face by more than the uncertainties, or overlaps this element by 1e-6 of its size, is not behind
/// it (see Documentation/curved-surfaces.md).
///
/// Serial; best called with neighbours. The answer for a point depends on that point alone.
void FindBehind(const Locator& locator, const ElementFace& face, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<BehindFace> behind);

/// Of any points of an element: `xi`, and `x`, their images. A point is on a face where its
/// distance in xi is at most 1e-9; on edges and vertices, the first face with an element behind it
/// counts. Points on no face: Outside. Serial; the answer for a point depends on that point alone.
void FindBehindPoints(const Locator& locator, int element, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<BehindFace> behind);
} // namespace pixelexact
