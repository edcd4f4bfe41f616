// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Vec.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pixelexact
{
/// Polynomials over a box in tensor-product Bernstein form, raised to one degree and side by side:
/// what is asked of all of them is done in lanes.
class PolynomialBatch
{
public:
  /// None of higher degree than `degree`, and finite.
  PolynomialBatch(const Degrees& degree, std::span<const BoxPolynomial> polynomials);

  [[nodiscard]] std::size_t Count() const { return Errors.size(); }
  [[nodiscard]] std::size_t Bytes() const { return sizeof(double) * B.size(); }

  /// All values of each over a part of the box, given in the box's own [-1, 1]^3: the hulls of the
  /// coefficients there.
  void HullsOver(const Box3& within, std::span<Interval> hulls) const;

private:
  Degrees Degree;
  std::vector<double> B; ///< number c of the batch: at c + Count() times BoxPolynomial's index
  std::vector<double> Errors;
  std::vector<double> Largest; ///< bound of the coefficients' magnitudes, before and after
};
} // namespace pixelexact
