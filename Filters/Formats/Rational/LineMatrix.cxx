// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Rational/LineMatrix.h"

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/LineFunctions.h"
#include "Core/Basis/Recurrence.h"

#include <algorithm>
#include <cfloat>
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

/// The recurrences multiply rounding by about 2.4 a step. In 113 bits it stays below a rounding of
/// long double up to order 32.
#if LDBL_MANT_DIG >= 113
using Wide = long double;
#else
__extension__ using Wide = __float128;
#endif

/// Appends h^power P_n^alpha at the points, h = (1 - z) / 2, for n = 0 to `last`, points fastest.
void AddModes(int alpha, int power, int last, const std::vector<long double>& points,
  std::vector<long double>& table)
{
  std::vector<Wide> before(points.size(), 0);
  std::vector<Wide> now(points.size(), 1);
  for (int n = 0; n <= last; ++n)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const auto polynomial = static_cast<long double>(now[i]);
      table.push_back(polynomial * std::pow((1 - points[i]) / 2, power));
    }
    const auto step =
      alpha == 0 ? Recurrence<Wide>::Legendre(n) : Recurrence<Wide>::Jacobi(alpha, n);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Wide next = (step.a * static_cast<Wide>(points[i]) + step.b) * now[i] -
        (n == 0 ? Wide(0) : step.c * before[i]);
      before[i] = now[i];
      now[i] = next;
    }
  }
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

CollapsedModes::CollapsedModes(const Space& space, std::array<std::vector<long double>, 3> eta)
  : Target(space)
  , Size{ eta[0].size(), eta[1].size(), eta[2].size() }
{
  const bool isPrism = space.shape == Shape::Prism;
  AddModes(0, 0, space.order[0], eta[0], Tables[0]);
  for (int p = 0; p <= space.order[0]; ++p)
  {
    AddModes(isPrism ? 0 : 2 * p + 1, isPrism ? 0 : p, space.LastQ(p), eta[1], Tables[1]);
    for (int q = 0; q <= space.LastQ(p); ++q)
    {
      const int power = isPrism ? p : p + q;
      AddModes(isPrism ? 2 * p + 1 : 2 * power + 2, power, space.LastR(p, q), eta[2], Tables[2]);
    }
  }
}

int CollapsedModes::Roundings() const
{
  const auto [p, q, r] = Target.order;
  // Roundings of the power, of entries and products of three tables, and of the sums.
  return 3 * kMaxOrder + 8 + 2 * (p + q + r + 3);
}

std::vector<long double> CollapsedModes::Sum(
  std::span<const double> coefficients, bool isMagnitude) const
{
  const auto entry = [isMagnitude](long double x) { return isMagnitude ? std::fabs(x) : x; };
  std::vector<long double> result(Size[0] * Size[1] * Size[2], 0.0L);
  std::vector<long double> overR(Size[2]);
  std::vector<long double> overQ(Size[1] * Size[2]);
  auto coefficient = coefficients.begin();
  auto inR = Tables[2].begin();
  auto inQ = Tables[1].begin();
  auto inP = Tables[0].begin();
  for (int p = 0; p <= Target.order[0]; ++p)
  {
    overQ.assign(overQ.size(), 0.0L);
    for (int q = 0; q <= Target.LastQ(p); ++q)
    {
      overR.assign(overR.size(), 0.0L);
      for (int r = 0; r <= Target.LastR(p, q); ++r)
      {
        const long double factor = entry(*coefficient++);
        for (long double& sum : overR)
        {
          sum += factor * entry(*inR++);
        }
      }
      auto to = overQ.begin();
      for (std::size_t i = 0; i < Size[1]; ++i)
      {
        const long double factor = entry(*inQ++);
        for (const long double sum : overR)
        {
          *to++ += factor * sum;
        }
      }
    }
    auto to = result.begin();
    for (std::size_t i = 0; i < Size[0]; ++i)
    {
      const long double factor = entry(*inP++);
      for (const long double sum : overQ)
      {
        *to++ += factor * sum;
      }
    }
  }
  return result;
}

CollapsedModes::Values CollapsedModes::Evaluate(std::span<const double> coefficients) const
{
  return { Sum(coefficients, false), Sum(coefficients, true) };
}
} // namespace pixelexact::rational
