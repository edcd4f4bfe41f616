// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/AffineForm.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// A polynomial over a box in tensor-product Bernstein form, each coefficient known to `error`.
struct BoxPolynomial
{
  std::array<int, 3> degree{};
  std::vector<double> b; ///< index (i (Q+1) + j) (R+1) + k
  double error = 0.0;

  /// All values over the box: the hull of the coefficients. Exact where the error is zero.
  [[nodiscard]] Interval Hull() const;
  /// Whether it is zero throughout, exactly.
  [[nodiscard]] bool IsZero() const;
  /// The value at a corner of the box; bit d of `corner`: the upper end along direction d.
  [[nodiscard]] Interval AtCorner(unsigned corner) const;
  /// The value at t in [-1, 1]^3, the box's own coordinates.
  [[nodiscard]] Interval At(const std::array<double, 3>& t) const;
  /// Its affine part over the box and the hull of what is left: an affine function has its values
  /// on the coefficients' grid as coefficients.
  [[nodiscard]] AffineForm Affine() const;
  /// The largest first or second difference of neighbours along a direction, times degree or degree
  /// (degree - 1): how far from constant, or from linear, the polynomial is there.
  [[nodiscard]] double Variation(int direction, int difference) const;

  /// The polynomial at an end of the box along a direction, in which it then has degree 0.
  [[nodiscard]] BoxPolynomial AtEnd(int direction, bool upper) const;
  /// Becomes the lower half along a direction and returns the upper one.
  BoxPolynomial Subdivide(int direction);
  /// Becomes its restriction to `from` <= eta_direction <= `to`, parts of [-1, 1], which is the
  /// box.
  void Restrict(int direction, double from, double to);
};
} // namespace pixelexact
