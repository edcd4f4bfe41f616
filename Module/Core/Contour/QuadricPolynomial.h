// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CutFunction.h"
#include "Core/Element/Mesh.h"
#include "Core/Element/RangeIngredients.h"

namespace pixelexact
{
/// A component of a function, in its modes' units, over a box of eta that lies in one piece of this
/// level.
BoxPolynomial ValuesOver(const ScaledModes& modes, int component, int level, const Box3& box);

/// A quadric's function S over a part of an element, as a polynomial in eta.
struct ScaledQuadric
{
  BoxPolynomial s; ///< unit times S
  double unit;     ///< a power of two, the same for all of the element
};
/// `map`: that of the element. The box lies in one piece of this level.
ScaledQuadric QuadricOver(const Mesh& mesh, int element, const ScaledModes& map,
  const QuadricForm& form, int level, const Box3& box);
/// A^2 - B of the two quadrics of a QuarticForm over the same box; its unit is that of A squared.
ScaledQuadric QuarticOver(const ScaledQuadric& a, const ScaledQuadric& b);
/// The same from the map over the box, y in x = centre + radius y. `isLocal`: S is expanded about a
/// point of the box's image, not about the element's centre, so that its error is about that of y
/// times the gradient there: it falls with the box where S and its gradient do (two planes that
/// nearly coincide, a small sphere).
ScaledQuadric QuadricOf(const Mesh& mesh, int element, double radius, const QuadricForm& form,
  std::array<BoxPolynomial, 3> y, bool isLocal);
} // namespace pixelexact
