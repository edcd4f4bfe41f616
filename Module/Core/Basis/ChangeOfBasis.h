// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/FactorKernels.h"

#include <functional>
#include <span>
#include <vector>

// Converts from a source's basis to the canonical one. The matrices are computed in long double (64
// bits of mantissa on x86), once per kind of element, applied with no fewer bits, and the result is
// rounded to double.
namespace pixelexact
{
/// One-dimensional and simplicial families of source bases.
enum class Family : std::uint8_t
{
  EquispacedLagrange, ///< nodes equispaced with both ends; order 0: the centre
  /// Nodes at the Gauss-Lobatto-Legendre points; order 0: the centre. In triangles and tetrahedra
  /// to order 3, where symmetry leaves the nodes inside no choice; others are Unsupported.
  GaussLobattoLagrange,
  Bernstein
};

/// A linear map from source coefficients to canonical ones, kept as Kronecker factors where the
/// shape allows (hexahedron: three lines; prism: triangle and line), dense otherwise.
class ChangeOfBasis
{
public:
  /// Hexahedron of space.order. `source[(i (q+1) + j) (r+1) + k]` is the position, in the source's
  /// cell, of the function that is number i, j, k along xi1, xi2, xi3.
  static ChangeOfBasis Hexahedron(const Space& space, Family family, std::span<const int> source);

  /// Prism with triangle order space.order[0] = space.order[2] and line order space.order[1].
  /// Triangle functions are numbered by (i, k), i + k <= n, k fastest, i and k counting towards
  /// the vertices xi1 = 1 and xi3 = 1; `source[t (q+1) + j]` is the position in the cell of
  /// triangle function t times line function j (along xi2).
  static ChangeOfBasis Prism(const Space& space, Family family, std::span<const int> source);

  /// Tetrahedron of uniform order n: functions numbered by (i, j, k), i + j + k <= n, k fastest,
  /// counting towards the vertices xi1 = 1, xi2 = 1, xi3 = 1.
  static ChangeOfBasis Tetrahedron(const Space& space, Family family, std::span<const int> source);

  /// Hexahedron with tensor products of any line functions: `source[(i n2 + j) n3 + k]` is the
  /// position of the product of functions i, j, k along xi1, xi2, xi3 in the source's element,
  /// which may hold others as well. Throws InvalidData where a line's functions exceed the space's
  /// order.
  static ChangeOfBasis FromLines(
    const Space& space, const std::array<LineFunctions, 3>& lines, std::span<const int> source);

  /// Prism with products of functions on the triangle, of (xi1, xi3), and on the line, of xi2:
  /// `source[t n + j]`, n the number of line functions. Throws as FromLines.
  static ChangeOfBasis FromTriangleAndLine(const Space& space, int triangleFunctions,
    const std::function<void(long double xi1, long double xi3, long double*)>& triangle,
    const LineFunctions& line, std::span<const int> source);

  /// Any source functions that lie in `space`: `functions(xi, values)` writes the `sources` values
  /// at xi. Throws InvalidData where the functions do not lie in the space (up to 1e-10).
  static ChangeOfBasis FromFunctions(const Space& space, int sources,
    const std::function<void(const LongVec3&, long double*)>& functions);

  [[nodiscard]] const Space& Target() const { return TargetSpace; }
  /// The factors of the Kronecker product: three lines, a triangle and a line, or one factor for
  /// all modes of the space.
  [[nodiscard]] std::span<const BasisFactor> GetFactors() const { return Factors; }
  [[nodiscard]] int SourceSize() const { return static_cast<int>(SourceOf.size()); }

  /// canonical[mode] = sum over s of M[mode][s] (values[s] - shift). Shifting is exact where the
  /// basis sums to one; used for geometry, whose modes are wanted relative to a centre. Safe to
  /// call from several threads.
  void Apply(std::span<const double> values, double shift, std::span<double> canonical) const;

  /// Buffers of Apply. Each thread has its own and reuses its memory.
  struct Scratch
  {
    PairBuffer from;
    PairBuffer to;
  };
  /// The same for as many components as there are shifts, one after the other in `values` and in
  /// `canonical`. The results have the same bits as those of single components.
  void Apply(std::span<const double> values, std::span<const double> shifts,
    std::span<double> canonical, Scratch& scratch) const;

  /// sum over s of |M[mode][s]|: the largest change of a mode if each source value changes by at
  /// most one unit.
  [[nodiscard]] std::span<const double> Amplification() const { return RowNorm; }

private:
  ChangeOfBasis(const Space& space, std::vector<BasisFactor> factors, std::span<const int> source,
    std::vector<int> modeOf);

  void ApplyInLongDouble(
    std::span<const double> values, double shift, std::span<double> canonical) const;

  Space TargetSpace;
  std::vector<BasisFactor> Factors;
  std::vector<PairMatrix> Matrices; ///< the factors'
  std::vector<int> SourceOf; ///< position in the source of each combination of factor columns
  std::vector<int> ModeOf;   ///< mode of each combination of factor rows
  std::vector<double> RowNorm;
};
} // namespace pixelexact
