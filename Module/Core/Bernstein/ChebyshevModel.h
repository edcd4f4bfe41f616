// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Interval.h"

#include <array>
#include <cstddef>

namespace pixelexact
{
/// Rounds up by enough for fewer than 4000 roundings of sums and products of bounds, and for
/// underflow.
inline double Up(double bound)
{
  return bound * (1.0 + 0x1p-40) + 0x1p-1000;
}

/// A function of (s, t) in [-1,1]^2, known up to `error` everywhere in the square:
///   f(s, t) = sum of c_ij T_i(s) T_j(t), i + j <= kDegree, +- error
/// with Chebyshev polynomials T_i. Each operation adds the terms of higher degree that it drops,
/// and its roundings, to the error, so that results are proven (Chebyshev models: N. Brisebarre, M.
/// Joldes, Chebyshev interpolation polynomial-based tools for rigorous computing, ISSAC 2010; here
/// of two variables and total degree). The error is infinite where no bound is known.
class ChebyshevModel
{
public:
  static constexpr int kDegree = 8;
  static constexpr std::size_t kSize = std::size_t{ kDegree + 1 } * (kDegree + 2) / 2;

  /// The index of c_ij.
  static constexpr std::size_t Index(int i, int j)
  {
    const int at = i * (kDegree + 1) - i * (i - 1) / 2 + j;
    return static_cast<std::size_t>(at);
  }

  ChebyshevModel() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number is a model of degree 0.
  ChebyshevModel(const Interval& value);
  // NOLINTNEXTLINE(google-explicit-constructor)
  ChebyshevModel(double value) { c[0] = value; }

  static ChebyshevModel First();  ///< s
  static ChebyshevModel Second(); ///< t

  std::array<double, kSize> c{};
  double error = 0.0;

  /// Bounds the sum of the coefficients' magnitudes, optionally without the first one.
  [[nodiscard]] double Norm(bool withFirst = true) const;
  /// Encloses all values.
  [[nodiscard]] Interval Range() const;
  /// A narrower range at a higher cost: the hull of the coefficients in Bernstein form.
  [[nodiscard]] Interval TightRange() const;
  /// The integral over the square.
  [[nodiscard]] Interval Integral() const;
  /// The same coefficients, without the error.
  [[nodiscard]] ChebyshevModel Polynomial() const;
  /// The function f(t, s).
  [[nodiscard]] ChebyshevModel Transposed() const;
  /// The product with a number that is exact.
  [[nodiscard]] ChebyshevModel Times(double factor) const;
  // Found by argument-dependent lookup of models alone, so that numbers times intervals stay
  // intervals.
  friend ChebyshevModel operator*(double a, const ChebyshevModel& b) { return b.Times(a); }
  /// The derivative by t. Its error is infinite if the model has an error.
  [[nodiscard]] ChebyshevModel ByT() const;
  /// Increases the error by `radius`.
  void Widen(double radius);
};

ChebyshevModel operator+(const ChebyshevModel& a, const ChebyshevModel& b);
ChebyshevModel operator-(const ChebyshevModel& a, const ChebyshevModel& b);
ChebyshevModel operator*(const ChebyshevModel& a, const ChebyshevModel& b);

/// 1 / f. The error is infinite where f may vanish, or varies too much for the degree.
ChebyshevModel Reciprocal(const ChebyshevModel& f);
/// The square root of f, which must be positive; otherwise the error is infinite.
ChebyshevModel SquareRoot(const ChebyshevModel& f);

/// Adds the share of the model's highest terms along each variable. Subdivision along a variable
/// with a larger share gains more.
void AddRoughness(const ChebyshevModel& model, std::array<double, 2>& along);
/// Whether the model's error exceeds what its highest terms explain, as at kinks and steps. The
/// longest side is then the best one to subdivide.
[[nodiscard]] bool IsRange(const ChebyshevModel& model);
} // namespace pixelexact
