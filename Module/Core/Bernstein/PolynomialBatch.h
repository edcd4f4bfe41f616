// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pixelexact
{
/// A function f of three coordinates x: |f(x) - value - slope . x| <= radius.
struct AffineBound
{
  double value = 0.0;
  std::array<double, 3> slope{};
  double radius = 0.0;
};

/// Polynomials over a box in tensor-product Bernstein form, raised to one degree and side by side,
/// so that operations on all of them run in lanes.
class PolynomialBatch
{
public:
  /// None of higher degree than `degree`, and finite.
  PolynomialBatch(const Degrees& degree, std::span<const BoxPolynomial> polynomials);

  [[nodiscard]] std::size_t Count() const { return Errors.size(); }
  [[nodiscard]] const Degrees& Degree() const { return degree_; }
  [[nodiscard]] std::size_t Bytes() const { return sizeof(double) * B.size(); }

  /// All values of each over a part of the box, given in the box's own [-1, 1]^3: the hulls of the
  /// coefficients there.
  void HullsOver(const Box3& within, std::span<Interval> hulls) const;
  /// And, of the last ones, as many as there are `bounds`, in terms of coordinates x that are
  /// polynomials of the batch's degree: `places` are their coefficients over the part, off by at
  /// most 64 roundoffs. The slopes are those of the corners, by least squares.
  void BoundsOver(const Box3& within, std::span<Interval> hulls, std::span<const Vec3> places,
    std::span<AffineBound> bounds) const;

  /// The same polynomials with lower degrees, where the omitted part is at most this fraction of
  /// the largest of all coefficients. The errors include it. Directions in which the batch is not
  /// constant keep at least degree 1.
  [[nodiscard]] PolynomialBatch Lowered(double part) const;

private:
  /// Lowers to the lowest degree in a direction for which the omitted part is at most `most`.
  void LowerAlong(int direction, double most);

  /// The coefficients over a part of the box, with their errors.
  struct Restricted
  {
    std::vector<double> rounds[2];
    std::vector<double> errors;
    const std::vector<double>* b = nullptr;
  };
  void RestrictTo(const Box3& within, Restricted& part) const;
  void FindHulls(const Restricted& part, std::span<Interval> hulls) const;
  void FindBounds(
    const Restricted& part, std::span<const Vec3> places, std::span<AffineBound> bounds) const;

  Degrees degree_;
  std::vector<double> B; ///< number c of the batch: at c + Count() times BoxPolynomial's index
  std::vector<double> Errors;
  std::vector<double> Largest; ///< bound of the coefficients' magnitudes, before and after
};
} // namespace pixelexact
