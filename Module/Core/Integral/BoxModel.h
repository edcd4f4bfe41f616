// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Bernstein/ChebyshevModel.h"

#include <array>

namespace pixelexact
{
/// A polynomial of three variables over a box, in Chebyshev polynomials of total degree
/// ChebyshevModel::kDegree; `error` bounds the remainder. The variables (a, b, c) are the box's
/// directions in any order. The third one, and with `wideB` the second one, reach kReach beyond the
/// box, so that functions that nearly leave it can be substituted.
class BoxModel
{
public:
  /// The reach from the middle of the box, in units of its half width.
  static constexpr double kReach = 1.0 + 1.0 / 16.0;

  /// `axes`: the box's directions of a, b and c.
  BoxModel(const BoxPolynomial& polynomial, const std::array<int, 3>& axes, bool wideB);

  /// Encloses the values where |a| <= 1, |b| <= 1 or kReach, |c| <= kReach.
  [[nodiscard]] Interval Range() const;

private:
  friend class PointedModels;
  static constexpr int kDegree = ChebyshevModel::kDegree;
  /// [k][j][i], i + j + k <= kDegree.
  std::array<std::array<std::array<double, kDegree + 1>, kDegree + 1>, kDegree + 1> P{};
  double Error = 0.0;
  double SlopeB = 0.0; ///< bounds of the derivatives of what is kept
  double SlopeC = 0.0;
};

/// Places (s, b(s, t), c(s, t)) at which several polynomials are evaluated.
class PointedModels
{
public:
  PointedModels(const ChebyshevModel& b, const ChebyshevModel& c);
  /// The same with b = t.
  explicit PointedModels(const ChebyshevModel& c);

  /// Whether both stay within BoxModel::kReach. If not, no polynomial may be evaluated.
  [[nodiscard]] bool IsWithin() const { return Within; }
  /// Whether polynomials must reach beyond the box along b.
  [[nodiscard]] bool IsWideB() const { return !PlainB; }
  /// f at the places. If IsWideB, f must reach beyond the box along b. The errors of b and c are
  /// included in the error of the value.
  [[nodiscard]] ChebyshevModel Of(const BoxModel& f) const;

private:
  using Powers = std::array<ChebyshevModel, ChebyshevModel::kDegree + 1>;
  static Powers PowersOf(const ChebyshevModel& argument);

  bool Within;
  bool PlainB = false;
  double ErrorB = 0.0;
  double ErrorC;
  Powers B; ///< T_j(b / kReach), unless b is t
  Powers C;
};
} // namespace pixelexact
