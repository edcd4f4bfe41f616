// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/SecondDerivatives.h"

#include "Core/Element/Dual.h"

namespace pixelexact
{
namespace
{
template <template <class, class, bool> class Modes>
Hessian Evaluate(const Space& space, const double* coefficients, const Vec3& xi)
{
  using namespace HWY_NAMESPACE;
  const Modes<Dual, AnyOrder, true> modes(space,
    Point<Dual>{ { Dual::Variable(xi.x, 0), Dual::Variable(xi.y, 1), Dual::Variable(xi.z, 2) } });
  Hessian hessian;
  for (int c = 0; c < 3; ++c)
  {
    const auto e = modes.Evaluate(coefficients + static_cast<std::ptrdiff_t>(c) * space.Modes());
    for (int j = 0; j < 3; ++j)
    {
      const auto& row = e.gradient[j].derivative;
      hessian[c][j] = { row[0], row[1], row[2] };
    }
  }
  return hessian;
}
} // namespace

Hessian SecondDerivatives(const Space& space, const double* coefficients, const Vec3& xi)
{
  using namespace HWY_NAMESPACE;
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return Evaluate<HexahedronModes>(space, coefficients, xi);
    case Shape::Prism:
      return Evaluate<PrismModes>(space, coefficients, xi);
    case Shape::Tetrahedron:
      return Evaluate<TetrahedronModes>(space, coefficients, xi);
    default:
      return space.form == Form::Tensor ? Evaluate<TensorPyramidModes>(space, coefficients, xi)
                                        : Evaluate<PyramidModes>(space, coefficients, xi);
  }
}
} // namespace pixelexact
