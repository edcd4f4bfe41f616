// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

// Tensor grids in long double and the matrices that act along one of their directions.
namespace pixelexact::rational
{
/// Row-major; from `columns` numbers along a line to `rows`.
struct LineMatrix
{
  int rows = 0;
  int columns = 0;
  std::vector<long double> entries;

  /// The largest sum of a row's absolute values.
  [[nodiscard]] long double Norm() const;
};

/// From Bernstein's coefficients of that degree on [-1,1] to values at points.
LineMatrix BernsteinAt(int degree, const std::vector<long double>& points);

/// From values at distinct nodes to the values at points of the polynomial through them.
LineMatrix LagrangeAt(
  const std::vector<long double>& nodes, const std::vector<long double>& points);

/// n zeros of Chebyshev's polynomial T_n, ascending.
std::vector<long double> ChebyshevZeros(int n);

/// Nodes of a line of that order: Gauss-Lobatto-Legendre points; order 0: the centre.
std::vector<long double> NodesOf(int order);

using GridSize = std::array<int, 3>;

/// The number of a grid's points.
std::size_t PointsOf(const GridSize& size);

/// Replaces `grid`, of `size` points with the last direction fastest, by what the matrix makes of
/// each of its lines along `direction`; `size` becomes the new one.
void Sweep(std::vector<long double>& grid, GridSize& size, int direction, const LineMatrix& matrix);
} // namespace pixelexact::rational
