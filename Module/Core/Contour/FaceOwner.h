// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CurvePoint.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"

namespace pixelexact
{
/// Who draws contours that lie in faces, where each element has them.
class FaceOwner
{
public:
  FaceOwner(const Locator& locator, const FaceTable& faces)
    : locator_(locator)
    , Faces(faces)
  {
  }

  /// Whether a point in this face of an element is drawn by another one: of two elements that share
  /// a face the lower, of larger and smaller faces the smaller.
  [[nodiscard]] bool IsAnothers(int element, int face, const CurvePoint& point) const;

private:
  /// An estimate of the area of the face, in world units squared.
  [[nodiscard]] double AreaOf(int element, int face) const;
  /// The smallest face of another element at the point; none where there is none.
  [[nodiscard]] ElementFace SmallestOther(int element, const Vec3& x) const;

  const Locator& locator_;
  const FaceTable& Faces;
};
} // namespace pixelexact
