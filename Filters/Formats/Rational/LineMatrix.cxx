// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Rational/LineMatrix.h"

#include "Core/Basis/BasisFactor.h"
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

const LineMatrix& LineTables::Find(Kind kind, int from, int to)
{
  const std::lock_guard lock(Access);
  auto& known = Known[{ kind, from, to }];
  if (!known)
  {
    LineMatrix made;
    switch (kind)
    {
      case Kind::BernsteinToNodes:
        made = BernsteinAt(from, NodesOf(to));
        break;
      case Kind::BernsteinToSamples:
        made = BernsteinAt(from, ChebyshevZeros(to));
        break;
      case Kind::NodesToSamples:
        made = LagrangeAt(NodesOf(from), ChebyshevZeros(to));
        break;
      case Kind::NodesToLegendre:
        BasisFactor factor = LineFactor(from, Lagrange(NodesOf(from)));
        made = { factor.rows, factor.columns, std::move(factor.matrix) };
        break;
    }
    known = std::make_unique<LineMatrix>(std::move(made));
  }
  return *known;
}

const LineMatrix& LineTables::BernsteinToNodes(int degree, int order)
{
  return Find(Kind::BernsteinToNodes, degree, order);
}

const LineMatrix& LineTables::BernsteinToSamples(int degree, int samples)
{
  return Find(Kind::BernsteinToSamples, degree, samples);
}

const LineMatrix& LineTables::NodesToSamples(int order, int samples)
{
  return Find(Kind::NodesToSamples, order, samples);
}

const LineMatrix& LineTables::NodesToLegendre(int order)
{
  return Find(Kind::NodesToLegendre, order, order);
}
} // namespace pixelexact::rational
