// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BernsteinForm.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// The space whose cube is halved.
enum class BoxSpace : std::uint8_t
{
  /// eta. The cube is the shape, but towards collapsed edges of prisms and tetrahedra the Jacobian
  /// vanishes, and boxes there do not become nearly affine.
  Tensor,
  /// xi, in which the maps of hexahedra, prisms and tetrahedra are polynomials, continued over the
  /// cube [-1,1]^3, of which prisms and tetrahedra fill a part. Pyramids, whose maps are rational
  /// in xi, stay in the tensor space.
  Reference
};

/// An element's map in tensor-product Bernstein form over the cube of a space.
struct BoxForm
{
  /// `coefficients`: canonical modes of Phi, three components.
  BoxForm(const Space& space, const double* coefficients, BoxSpace boxSpace);

  /// False where no point of a box with this lower corner is within 1e-6 of the shape.
  [[nodiscard]] bool MeetsShape(Shape shape, const Vec3& lowerCorner) const;

  bool inReferenceSpace; ///< boxes are of xi (for hexahedra they always are)
  std::array<int, 3> degree;
  std::vector<double> map;     ///< Bernstein coefficients, component by component
  std::array<double, 3> error; ///< of each coefficient
};
} // namespace pixelexact
