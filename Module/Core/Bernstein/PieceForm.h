// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Bernstein/FactorRow.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// The part of a function to convert: its value, or its derivative by a xi.
enum class Part : signed char
{
  Value = -1,
  ByXi1 = 0,
  ByXi2 = 1,
  ByXi3 = 2
};
inline constexpr Part kDerivatives[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };

/// The tensor-product Bernstein form, in eta over pieces of the cube, of functions given by
/// canonical modes and of their derivatives by xi, which are polynomials in eta as well: a mode is
/// a product X(eta1) Y(eta2) Z(eta3), and its derivatives are sums of at most three such products,
///
///   hexahedron   X'YZ,  XY'Z,  XYZ'
///   prism        X'Y Z/h,  XY'Z,  (1+eta1)/2 X'Y Z/h + XYZ'
///   tetrahedron  X' Y/h Z/h,  (1+eta1)/2 X' Y/h Z/h + XY' Z/h,
///                (1+eta1)/2 X' Y/h Z/h + X (1+eta2)/2 Y' Z/h + XYZ'
///   pyramid      X'Y Z/h,  XY' Z/h,  (1+eta1)/2 X'Y Z/h + X (1+eta2)/2 Y' Z/h + XYZ'
///
/// in which every factor that is divided by h = (1 - eta) / 2 carries it (or the derivative beside
/// it is zero): the derivatives are regular at collapsed edges and vertices. In a pyramid's Tensor
/// form Z carries no h; Z/h then stands for (Z - Z(1)) / h, the derivative of the *closed*
/// function, in which the modes with (p, q) != (0, 0) vanish at the apex. IsClosed checks whether
/// the given function is closed up to rounding; else its derivatives are unbounded at the apex.
///
/// Over the whole cube, coefficients of high orders are large and cancel, so that their rounding
/// errors are large as well. Spaces of order above 5, 11 and 23 are therefore converted on 2, 4 and
/// 8 pieces in each direction, with tables of the factors on each piece, at the same cost.
class PieceForm
{
public:
  using Piece = std::array<int, 3>; ///< numbers from 0 to Pieces() - 1 along each eta

  /// The conversion of a valid space; made on first use, kept, safe to call from several threads.
  static const PieceForm& Of(const Space& space);

  [[nodiscard]] const std::array<int, 3>& Degree() const { return degree_; }
  /// The number of coefficients: the product of degrees + 1; index (i (Q+1) + j) (R+1) + k.
  [[nodiscard]] std::size_t Size() const;
  /// log2 of the number of pieces along each direction.
  [[nodiscard]] int Level() const { return level_; }

  /// The level that a form of this highest order has.
  static int LevelOf(int order);
  /// The same form on 2^level pieces.
  static const PieceForm& Of(const Space& space, int level);

  /// Converts one component to Bernstein coefficients over a piece.
  void Convert(Part part, const Piece& piece, const double* modes, std::span<double> out) const;

  /// Bounds the rounding error of every coefficient that Convert computes from these modes:
  /// gamma(P + Q + R + 12) times the sum of |c| max |X| max |Y| max |Z|. Valid where the modes'
  /// largest magnitude is between 2^-500 and 2^500: nothing over- or underflows then.
  [[nodiscard]] double ErrorBound(Part part, const Piece& piece, const double* modes) const;

  /// Whether the derivatives by xi are those of the function itself. They always are, except for a
  /// pyramid's Tensor form, where the part that is not single-valued at the apex must be below
  /// 64 roundings of the coefficients.
  [[nodiscard]] static bool IsClosed(const Space& space, const double* modes);

private:
  struct Term
  {
    std::array<Factor, 3> factor;
  };
  PieceForm(const Space& space, int level);
  void MakeTables(const std::array<Factor, 3>& factor);
  [[nodiscard]] std::array<int, 3> FamilyOf(int p, int q) const;
  [[nodiscard]] std::size_t IndexOf(int direction, int piece, int family, int n) const;
  [[nodiscard]] const FactorRow& RowOf(
    int direction, Factor factor, int piece, int family, int n) const;
  [[nodiscard]] const double* LargestOf(
    int direction, Factor factor, int piece, int family, int n) const;
  void AddTerm(
    const Term& term, const Piece& piece, const double* modes, std::span<double> out) const;

  Space space_;
  int level_;
  std::array<int, 3> degree_;
  std::array<std::vector<Term>, 4> Terms; ///< by Part + 1
  /// [direction][factor], then (piece * families + family) * (degree + 1) + n; empty where unused.
  std::array<std::array<std::vector<FactorRow>, kFactors>, 3> Tables;
  std::array<std::array<std::vector<double>, kFactors>, 3> Largest; ///< of each of these rows
  std::array<int, 3> Families{ 1, 1, 1 };
};
} // namespace pixelexact
