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
  /// Whether the polynomial is exactly zero.
  [[nodiscard]] bool IsZero() const;
  /// The value at a corner of the box; bit d of `corner`: the upper end along direction d.
  [[nodiscard]] Interval AtCorner(unsigned corner) const;
  /// The value at t in [-1, 1]^3, the box's own coordinates.
  [[nodiscard]] Interval At(const std::array<double, 3>& t) const;
  /// The affine part over the box and the hull of the remainder. An affine function's coefficients
  /// are its values at the grid points of the coefficients.
  [[nodiscard]] AffineForm Affine() const;
  /// The largest first or second difference of neighbours along a direction, times degree or degree
  /// (degree - 1). It measures how far the polynomial is from constant or from linear.
  [[nodiscard]] double Variation(int direction, int difference) const;

  /// The polynomial at one end of the box along a direction. Its degree in that direction is 0.
  [[nodiscard]] BoxPolynomial AtEnd(int direction, bool upper) const;
  /// Becomes the lower half along a direction and returns the upper one.
  BoxPolynomial Subdivide(int direction);
  /// Restricts the polynomial to `from` <= eta_direction <= `to`, within [-1, 1], the range of the
  /// box.
  void Restrict(int direction, double from, double to);
};
} // namespace pixelexact
