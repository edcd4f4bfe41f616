// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Modes-inl.h"

namespace pixelexact::testing
{
/// visit(modes) with the evaluation templates' tables at a point, in any number type.
template <class T, bool kGradient, class Visit>
auto VisitModes(const Space& space, const std::array<T, 3>& xi, Visit&& visit)
{
  using namespace HWY_NAMESPACE;
  const Point<T> point{ { xi[0], xi[1], xi[2] } };
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return visit(HexahedronModes<T, AnyOrder, kGradient>(space, point));
    case Shape::Prism:
      return visit(PrismModes<T, AnyOrder, kGradient>(space, point));
    case Shape::Tetrahedron:
      return visit(TetrahedronModes<T, AnyOrder, kGradient>(space, point));
    default:
      return space.form == Form::Tensor
        ? visit(TensorPyramidModes<T, AnyOrder, kGradient>(space, point))
        : visit(PyramidModes<T, AnyOrder, kGradient>(space, point));
  }
}
} // namespace pixelexact::testing
