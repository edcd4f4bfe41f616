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
} // namespace pixelexact
