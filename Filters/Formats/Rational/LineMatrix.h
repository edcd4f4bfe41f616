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

/// Matrices that many elements share, each made when it is first asked for. For several threads.
class LineTables
{
public:
  /// From Bernstein's coefficients to the nodes of an order.
  const LineMatrix& BernsteinToNodes(int degree, int order);
  /// From Bernstein's coefficients to `samples` zeros of a Chebyshev polynomial.
  const LineMatrix& BernsteinToSamples(int degree, int samples);
  /// From the nodes of an order to these.
  const LineMatrix& NodesToSamples(int order, int samples);
  /// From the nodes of an order to Legendre's coefficients.
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
  /// Coefficients in order of storage to values with the last direction fastest. A value is off by
  /// at most Roundings() long double roundings of its magnitude.
  [[nodiscard]] Values Evaluate(std::span<const double> coefficients) const;
  [[nodiscard]] int Roundings() const;

private:
  /// Of direction 1 by p; of 2 by p and q; of 3 by p, q and r; each with its points fastest.
  using Table = std::vector<long double>;
  [[nodiscard]] std::vector<long double> Sum(
    std::span<const double> coefficients, bool isMagnitude) const;

  Space Target;
  std::array<std::size_t, 3> Size{};
  std::array<Table, 3> Tables;
};
} // namespace pixelexact::rational
