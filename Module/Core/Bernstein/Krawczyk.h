// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/TensorPolynomial.h"

#include <optional>
#include <span>

namespace pixelexact
{
/// Polynomials over a box, in the box's own coordinates t in [0,1]^n: coefficients polynomial by
/// polynomial, of common degrees, each known up to its polynomial's error.
struct LocalSystem
{
  int variables = 0; ///< n
  int equations = 0;
  Degrees degree{};
  std::span<const double> coefficients;
  std::span<const double> error; ///< per polynomial

  [[nodiscard]] std::span<const double> Polynomial(int k) const
  {
    const std::size_t count = CoefficientCount(degree);
    return coefficients.subspan(static_cast<std::size_t>(k) * count, count);
  }
};

/// Rows and columns beyond a system's size are not used.
using SmallMatrix = std::array<std::array<double, 3>, 3>;

/// The inverse by elimination; nothing where it is not finite.
std::optional<SmallMatrix> Inverse(int size, SmallMatrix matrix);

/// The image of Krawczyk's operator, for as many polynomials as variables, over the cube
/// U = [-reach, 1 + reach]^n:
///   K(U) = m - C f(m) + (I - C f'(U)) (U - m),
/// m the root that Newton's iteration finds in U or else the centre, C near f'(m)^-1. Every root in
/// U lies in K(U), and where K(U) lies inside U there is exactly one (R. Krawczyk, Newton-
/// Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 4, 1969; A. Neumaier,
/// Interval Methods for Systems of Equations, 1990, section 5.1).
struct KrawczykImage
{
  ParameterIntervals image; ///< K(U); tightened where it holds exactly one root
  bool unique = false;      ///< exactly one root in U, and it lies in `image`
};

/// None where f'(m) cannot be inverted.
std::optional<KrawczykImage> ApplyKrawczyk(const LocalSystem& system, double reach);
} // namespace pixelexact
