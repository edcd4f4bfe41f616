// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Interval.h"

#include <array>
#include <cstddef>

namespace pixelexact
{
/// Covers the roundings of sums and products of bounds, of which there are fewer than 4000, and
/// underflow.
inline double Up(double bound)
{
  return bound * (1.0 + 0x1p-40) + 0x1p-1000;
}

/// A function of (s, t) in [-1,1]^2, known up to `error` everywhere in the square:
///   f(s, t) = sum of c_ij T_i(s) T_j(t), i + j <= kDegree, +- error
/// T_i: Chebyshev's polynomials. What an operation cannot keep, terms of higher degree and
/// roundings, goes to the error: what is concluded is proven (Chebyshev models: N. Brisebarre,
/// M. Joldes, Chebyshev interpolation polynomial-based tools for rigorous computing, ISSAC 2010;
/// here of two variables and total degree). Where nothing is known the error is infinite.
class ChebyshevModel
{
public:
  static constexpr int kDegree = 8;
  static constexpr std::size_t kSize = std::size_t{ kDegree + 1 } * (kDegree + 2) / 2;

  /// Where c_ij is.
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

  /// A bound of the sum of the coefficients' magnitudes, without the first one where asked.
  [[nodiscard]] double Norm(bool withFirst = true) const;
  /// Holds all values.
  [[nodiscard]] Interval Range() const;
  /// The same, narrower and dearer: the hull of the coefficients in Bernstein's form.
  [[nodiscard]] Interval TightRange() const;
  /// Over the square.
  [[nodiscard]] Interval Integral() const;
  /// The same coefficients, exactly.
  [[nodiscard]] ChebyshevModel Polynomial() const;
  /// f(t, s).
  [[nodiscard]] ChebyshevModel Transposed() const;
  /// By a number that is exact.
  [[nodiscard]] ChebyshevModel Times(double factor) const;
  // Found for models alone: numbers times intervals are intervals.
  friend ChebyshevModel operator*(double a, const ChebyshevModel& b) { return b.Times(a); }
  /// Its derivative by t; where there is an error, nothing is known of it.
  [[nodiscard]] ChebyshevModel ByT() const;
  /// Up to `radius` more.
  void Widen(double radius);
};

ChebyshevModel operator+(const ChebyshevModel& a, const ChebyshevModel& b);
ChebyshevModel operator-(const ChebyshevModel& a, const ChebyshevModel& b);
ChebyshevModel operator*(const ChebyshevModel& a, const ChebyshevModel& b);

/// 1 / f. Its error is infinite where f may vanish, or varies too much for the degree.
ChebyshevModel Reciprocal(const ChebyshevModel& f);
/// The root of f, which must be positive; else the error is infinite.
ChebyshevModel SquareRoot(const ChebyshevModel& f);

/// Adds how much of a model, as a part of it, is in its highest terms, along each variable: where
/// there is more, halving gains more.
void AddRoughness(const ChebyshevModel& model, std::array<double, 2>& along);
} // namespace pixelexact
