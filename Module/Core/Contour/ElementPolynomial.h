// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ImplicitPolynomial.h"
#include "Core/Element/Mesh.h"
#include "Core/Element/RangeIngredients.h"

namespace pixelexact
{
/// A component of a function, in its modes' units, over a box of eta that lies in one piece of this
/// level.
BoxPolynomial ValuesOver(const ScaledModes& modes, int component, int level, const Box3& box);

/// A function S over a part of an element, as a polynomial in eta.
struct ScaledPolynomial
{
  BoxPolynomial s; ///< unit times S
  double unit;     ///< a power of two, the same for all of the element
};
/// A surface's polynomial over a box of eta that lies in one piece of this level. `map`: that of
/// the element.
ScaledPolynomial PolynomialOver(const Mesh& mesh, int element, const ScaledModes& map,
  const ImplicitPolynomial& surface, int level, const Box3& box);
/// The same from the map over the box, y in x = centre + radius y. `isLocal`: S is expanded about a
/// point of the box's image, not about the element's centre, so that its error is about that of y
/// times the gradient there: it falls with the box where S and its gradient do (two planes that
/// nearly coincide, a small sphere).
ScaledPolynomial PolynomialOf(const Mesh& mesh, int element, double radius,
  const ImplicitPolynomial& surface, std::array<BoxPolynomial, 3> y, bool isLocal);
} // namespace pixelexact
