// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Bernstein/FactorRow.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// The tensor-product Bernstein form, in eta over the cube, of functions given by canonical modes.
/// The values over the whole shape lie in the hull of the coefficients; subdivision of the domain
/// brings them quadratically closer.
///
/// Each mode is a product of three univariate polynomials in eta whose Bernstein coefficients have
/// a closed form: h^m P_n^{(a,0)} has (-1)^{n-i} C(n+a,i) C(n,i) / C(n+m,i) in degree n + m, then
/// raised to the space's degree. They are rounded once (FactorRow.h), so a converted coefficient B
/// of modes c is off by at most
///   gamma(P + Q + R + 9) * sum |c| |X| |Y| |Z|
/// (P + Q + R + 3 additions, 3 rounded factors, 3 products), which ErrorBound evaluates.
class BernsteinForm
{
public:
  /// The conversion of a space. Created on first use and kept; safe to call from several threads.
  static const BernsteinForm& Of(const Space& space);

  [[nodiscard]] const std::array<int, 3>& Degree() const { return degree_; }
  /// The number of coefficients: the product of degrees + 1; index (i (Q+1) + j) (R+1) + k.
  [[nodiscard]] int Size() const;

  /// Converts one component to Bernstein coefficients.
  void Convert(const double* modes, std::span<double> bernstein) const;

  /// Bounds the rounding error of every coefficient that Convert computes from these modes.
  [[nodiscard]] double ErrorBound(const double* modes) const;

  /// A wider bound from the modes' largest coefficients; it costs one sum.
  [[nodiscard]] double QuickErrorBound(const double* modes) const;

  /// The grid point of eta that belongs to a coefficient: a function that is affine in each eta
  /// has its values there as its coefficients.
  [[nodiscard]] Vec3 GridPoint(int i, int j, int k) const;

private:
  explicit BernsteinForm(const Space& space);
  void MakeRows();
  [[nodiscard]] int FamilyOf(int p, int q) const;
  template <bool kAbsolute>
  void Contract(const double* modes, std::span<double> bernstein) const;

  using Rows = std::vector<FactorRow>; ///< by function
  Space space_;
  std::array<int, 3> degree_;
  Rows X;                      ///< [p]
  std::vector<Rows> Y;         ///< [p of the family][q]
  std::vector<Rows> Z;         ///< [n of the family][r]
  std::vector<double> Largest; ///< magnitude of a coefficient of each mode
};

/// The least and the largest coefficient: the hull.
struct Hull
{
  double lower;
  double upper;
};
Hull HullOf(std::span<const double> bernstein);
} // namespace pixelexact
