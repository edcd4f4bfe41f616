// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Rational/LineMatrix.h"

#include "Core/Basis/LineFunctions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact::rational
{
namespace
{
LineMatrix Tabulate(const LineFunctions& line, const std::vector<long double>& points)
{
  LineMatrix matrix{ static_cast<int>(points.size()), line.count, {} };
  matrix.entries.resize(points.size() * static_cast<std::size_t>(line.count));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    line.evaluate(points[i], &matrix.entries[i * static_cast<std::size_t>(line.count)]);
  }
  return matrix;
}
} // namespace

long double LineMatrix::Norm() const
{
  long double largest = 0.0L;
  for (auto row = entries.begin(); row != entries.end(); row += columns)
  {
    long double sum = 0.0L;
    std::for_each(row, row + columns, [&sum](long double x) { sum += std::fabs(x); });
    largest = std::max(largest, sum);
  }
  return largest;
}

LineMatrix BernsteinAt(int degree, const std::vector<long double>& points)
{
  return Tabulate(Bernstein(degree), points);
}

LineMatrix LagrangeAt(const std::vector<long double>& nodes, const std::vector<long double>& points)
{
  return Tabulate(Lagrange(nodes), points);
}

std::vector<long double> ChebyshevZeros(int n)
{
  std::vector<long double> zeros;
  for (int k = n - 1; k >= 0; --k)
  {
    zeros.push_back(std::cos(std::numbers::pi_v<long double> * (2 * k + 1) / (2 * n)));
  }
  return zeros;
}

std::vector<long double> NodesOf(int order)
{
  return order == 0 ? std::vector<long double>{ 0.0L } : GaussLobattoPoints(order + 1);
}

std::size_t PointsOf(const GridSize& size)
{
  return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
    static_cast<std::size_t>(size[2]);
}

void Sweep(std::vector<long double>& grid, GridSize& size, int direction, const LineMatrix& matrix)
{
  const auto d = static_cast<std::size_t>(direction);
  std::size_t inner = 1;
  for (std::size_t k = d + 1; k < 3; ++k)
  {
    inner *= static_cast<std::size_t>(size[k]);
  }
  const auto columns = static_cast<std::size_t>(matrix.columns);
  const auto rows = static_cast<std::size_t>(matrix.rows);
  const std::size_t outer = PointsOf(size) / (inner * columns);
  std::vector<long double> result(outer * rows * inner, 0.0L);
  for (std::size_t o = 0; o < outer; ++o)
  {
    for (std::size_t r = 0; r < rows; ++r)
    {
      long double* to = &result[(o * rows + r) * inner];
      for (std::size_t c = 0; c < columns; ++c)
      {
        const long double factor = matrix.entries[r * columns + c];
        const long double* from = &grid[(o * columns + c) * inner];
        for (std::size_t i = 0; i < inner; ++i)
        {
          to[i] += factor * from[i];
        }
      }
    }
  }
  grid = std::move(result);
  size[d] = matrix.rows;
}
} // namespace pixelexact::rational
