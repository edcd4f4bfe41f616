// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Subdivision.h"

namespace pixelexact
{
/// The careful path: whether an element holds a point that the fast path could not decide. The
/// place of the certified engine for polynomial systems, which is to prove uniqueness too.
///
/// Prisms and tetrahedra are subdivided twice over: first in the tensor space, whose boxes fill
/// just the shape and exclude most points soonest; what is not decided there soon (points next to
/// faces, near collapsed edges) in the reference space, where every small box is nearly affine.
///
/// Made once per element, for any number of points; not to be shared between threads.
class CarefulInverse
{
public:
  CarefulInverse(const Mesh& mesh, int element, const ElementBounds& bounds)
    : Elements(mesh)
    , Element(element)
    , Bounds(bounds)
    , First(mesh, element, bounds, BoxSpace::Tensor)
  {
  }

  /// `knownRoot`: where Newton's iteration converged to, outside of the shape; NaN where it did
  /// not.
  SubdivisionResult Decide(const Vec3& x, const Vec3& knownRoot);

private:
  const Mesh& Elements;
  int Element;
  const ElementBounds& Bounds;
  Subdivision First;
  std::optional<Subdivision> Second;
};
} // namespace pixelexact
