// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/TensorPolynomial.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// One polynomial over the unit cube. Its coefficients are known up to `error`; every proof holds
/// for all polynomials within it.
struct TensorPolynomial
{
  Degrees degree{};
  std::vector<double> coefficients; ///< index (i (n_1 + 1) + j) (n_2 + 1) + k
  double error = 0.0;
};

/// f_k(t) = 0 for one to three polynomials of one to three parameters, over the unit cube.
class PolynomialSystem
{
public:
  /// Polynomials are elevated to common degrees. Directions from `variables` on must have degree 0.
  /// Throws InvalidData for anything else than 1 to 3 variables and polynomials, degrees above
  /// kMaxDegree, wrong numbers of coefficients, or a negative error. Coefficients that are not
  /// finite are allowed, and nothing will be proven with them.
  PolynomialSystem(int variables, std::span<const TensorPolynomial> polynomials);

  [[nodiscard]] int Variables() const { return variables_; }
  [[nodiscard]] int Equations() const { return static_cast<int>(Error.size()); }
  [[nodiscard]] const Degrees& Degree() const { return degree_; }
  /// The coefficients of all polynomials, one after the other.
  [[nodiscard]] std::span<const double> Coefficients() const { return coefficients_; }
  /// The error of each polynomial's coefficients.
  [[nodiscard]] std::span<const double> Errors() const { return Error; }

private:
  int variables_;
  Degrees degree_{};
  std::vector<double> coefficients_;
  std::vector<double> Error;
};
} // namespace pixelexact
