// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pixelexact
{
/// The forms of the one-dimensional factor h^m P_n^{(a,0)}(z), h = (1 - z) / 2, of a canonical mode
/// that occur in the mode's derivatives by xi (PieceForm.h).
enum class Factor : unsigned char
{
  Plain = 0,   ///< the factor
  Slope = 1,   ///< its derivative
  Tilted = 2,  ///< (1 + z) / 2 times its derivative
  Lowered = 3, ///< the factor over h: one power less; zero for m = 0
  Closed = 4   ///< (P_n - P_n(1)) / h
};
inline constexpr int kFactors = 5;

/// Bernstein coefficients of such a polynomial over a part of [-1, 1], with error bounds.
struct FactorRow
{
  std::vector<double> value;
  /// Each value is off by at most the unit roundoff times its magnitude, which is at least |value|.
  std::vector<double> magnitude;
  double largest = 0.0; ///< magnitude
};

/// The one-dimensional factor of a mode.
struct FactorKey
{
  int alpha;
  int n;
  int power; ///< m
};

/// The row in Bernstein form of `degree`, over the piece [2 k / K - 1, 2 (k + 1) / K - 1] with k =
/// `piece` and K = 2^`level`.
///
/// h^m P_n^{(a,0)} has the coefficients (-1)^{n-i} C(n+a,i) C(n,i) / C(n+m,i) in degree n + m. The
/// other forms follow by differences, multiplication by linear factors, degree elevation and
/// subdivision. All arithmetic is in sums of two doubles; sums of magnitudes beside the numbers
/// bound the cancellation.
FactorRow MakeFactorRow(const FactorKey& key, Factor factor, int degree, int level, int piece);
} // namespace pixelexact
