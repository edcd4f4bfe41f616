// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/TensorPolynomial.h"

#include <array>
#include <cstdint>
#include <span>

namespace pixelexact
{
/// Bernstein polynomials of some degrees at a point, evaluated once for all polynomials there, in
/// plain arithmetic.
class JetBasis
{
public:
  enum class Parts : std::uint8_t
  {
    Values,
    Jets
  };
  JetBasis(const Degrees& degree, const Parameters& t, Parts parts);

  [[nodiscard]] double ValueOf(std::span<const double> coefficients) const;
  /// Evaluates a polynomial's jet. The basis must have been constructed for jets.
  [[nodiscard]] Jet JetOf(std::span<const double> coefficients) const;

private:
  using Line = std::array<double, kMaxDegree + 1>;
  static void FillBasis(int n, double t, Line& basis);
  static void FillSlopes(int n, double t, Line& slope);

  Degrees Degree;
  // Filled up to the degrees.
  std::array<Line, 3> Basis;
  std::array<Line, 3> Slope;
};
} // namespace pixelexact
