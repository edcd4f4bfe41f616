// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

// Tensor grids in long double and the matrices that act along one of their directions.

namespace pixelexact::rational
{
/// A row-major matrix that maps `columns` numbers along a line to `rows`.
struct LineMatrix
{
  int rows = 0;
  int columns = 0;
  std::vector<long double> entries;

  /// The largest sum of a row's absolute values.
  [[nodiscard]] long double Norm() const;
};

/// The matrix from Bernstein's coefficients of a degree on [-1,1] to values at points.
LineMatrix BernsteinAt(int degree, const std::vector<long double>& points);

/// The matrix from values at distinct nodes to values at points of the interpolating polynomial.
LineMatrix LagrangeAt(
  const std::vector<long double>& nodes, const std::vector<long double>& points);

/// The n zeros of Chebyshev's polynomial T_n, ascending.
std::vector<long double> ChebyshevZeros(int n);

/// The nodes of a line of this order: Gauss-Lobatto-Legendre points; for order 0 the centre.
std::vector<long double> NodesOf(int order);

using GridSize = std::array<int, 3>;

/// The number of points of a grid.
std::size_t PointsOf(const GridSize& size);

/// Applies the matrix to each line of `grid` along `direction`. The grid has `size` points, the
/// last direction fastest; `size` becomes that of the result.
void Sweep(std::vector<long double>& grid, GridSize& size, int direction, const LineMatrix& matrix);

/// Matrices that many elements share, each created on first use. Thread-safe.
class LineTables
{
public:
  /// From Bernstein's coefficients to the nodes of an order.
  const LineMatrix& BernsteinToNodes(int degree, int order);
  /// From Bernstein's coefficients to `samples` zeros of a Chebyshev polynomial.
  const LineMatrix& BernsteinToSamples(int degree, int samples);
  /// From values at the nodes of an order to values at samples.
  const LineMatrix& NodesToSamples(int order, int samples);
  /// From values at the nodes of an order to Legendre's coefficients.
  const LineMatrix& NodesToLegendre(int order);

private:
  enum class Kind : std::uint8_t
  {
    BernsteinToNodes,
    BernsteinToSamples,
    NodesToSamples,
    NodesToLegendre
  };
  const LineMatrix& Find(Kind kind, int from, int to);

  std::mutex Access;
  std::map<std::tuple<Kind, int, int>, std::unique_ptr<LineMatrix>> Known;
};

/// A polynomial of a prism's or tetrahedron's space on a tensor grid of points in eta.
class CollapsedModes
{
public:
  CollapsedModes(const Space& space, std::array<std::vector<long double>, 3> eta);

  struct Values
  {
    std::vector<long double> value;
    /// Sum of |coefficient| times |mode|.
    std::vector<long double> magnitude;
  };
  /// Evaluates coefficients in order of storage on the grid, the last direction fastest. The error
  /// of a value is at most Roundings() long double roundings of its magnitude.
  [[nodiscard]] Values Evaluate(std::span<const double> coefficients) const;
  [[nodiscard]] int Roundings() const;

private:
  /// Table of direction 1 by p; of 2 by p and q; of 3 by p, q and r; each with its points fastest.
  using Table = std::vector<long double>;
  [[nodiscard]] std::vector<long double> Sum(
    std::span<const double> coefficients, bool isMagnitude) const;

  Space Target;
  std::array<std::size_t, 3> Size{};
  std::array<Table, 3> Tables;
};
} // namespace pixelexact::rational
