// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/ChangeOfBasis.h"

#include "Core/Base/Error.h"
#include "Core/Basis/Modes-inl.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace pixelexact
{
namespace
{
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Map;

template <template <class, class, bool> class Modes>
void Evaluate(const Space& space, const LongVec3& xi, long double* out)
{
  const Modes<long double, HWY_NAMESPACE::AnyOrder, false> modes(
    space, HWY_NAMESPACE::Point<long double>{ { xi[0], xi[1], xi[2] } });
  ForEachMode(space, [&](int p, int q, int r, int mode) { out[mode] = modes.Mode(p, q, r); });
}

long double Power(long double base, int exponent)
{
  long double result = 1.0L;
  for (int k = 0; k < exponent; ++k)
  {
    result *= base;
  }
  return result;
}

long double Binomial(int n, int k)
{
  long double result = 1.0L;
  for (int i = 1; i <= k; ++i)
  {
    result = result * (n - k + i) / i;
  }
  return result;
}

/// Equispaced nodes in [-1,1]; order 0 has its node at the centre.
long double Equispaced(int i, int order)
{
  return order == 0 ? 0.0L : 2.0L * i / order - 1.0L;
}

/// Chebyshev's points in [-1,1]: well conditioned at every order.
long double Chebyshev(int i, int order)
{
  return -std::cos(std::numbers::pi_v<long double> * (2 * i + 1) / (2 * (order + 1)));
}

/// Points at which interpolation in `space` is unique: the tensor grid of Chebyshev's points for
/// tensor spaces, and for collapsed ones their images, thinned out to the modes' staircase.
std::vector<LongVec3> UnisolventPoints(const Space& space)
{
  std::vector<LongVec3> points;
  points.reserve(space.Modes());
  const auto [P, Q, R] = space.order;
  ForEachMode(space,
    [&, P = P, Q = Q, R = R](int p, int q, int r, int /*mode*/)
    {
      // On the layer that belongs to q and r, only so many p's remain: spread them anew.
      const long double e3 = Chebyshev(r, R);
      LongVec3 eta{ Chebyshev(p, P), Chebyshev(q, Q), e3 };
      switch (space.shape)
      {
        case Shape::Hexahedron:
          points.push_back(eta);
          return;
        case Shape::Prism:
          eta[0] = Chebyshev(p, std::min<int>(P, R - r));
          points.push_back({ (1 + eta[0]) * (1 - e3) / 2 - 1, eta[1], e3 });
          return;
        case Shape::Tetrahedron:
          eta[0] = Chebyshev(p, std::min<int>({ P, Q - q, R - r - q }));
          eta[1] = Chebyshev(q, std::min<int>(Q, R - r));
          points.push_back({ (1 + eta[0]) * (1 - eta[1]) * (1 - e3) / 4 - 1,
            (1 + eta[1]) * (1 - e3) / 2 - 1, e3 });
          return;
        default:
          if (space.form == Form::Collapsed)
          {
            eta[0] = Chebyshev(p, std::min<int>(P, R - r));
            eta[1] = Chebyshev(q, std::min<int>(Q, R - r));
          }
          points.push_back(
            { (1 + eta[0]) * (1 - e3) / 2 - 1, (1 + eta[1]) * (1 - e3) / 2 - 1, e3 });
      }
    });
  return points;
}
} // namespace

void EvaluateModes(const Space& space, const LongVec3& xi, long double* out)
{
  using namespace HWY_NAMESPACE;
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return Evaluate<HexahedronModes>(space, xi, out);
    case Shape::Prism:
      return Evaluate<PrismModes>(space, xi, out);
    case Shape::Tetrahedron:
      return Evaluate<TetrahedronModes>(space, xi, out);
    default:
      return space.form == Form::Tensor ? Evaluate<TensorPyramidModes>(space, xi, out)
                                        : Evaluate<PyramidModes>(space, xi, out);
  }
}

ChangeOfBasis::ChangeOfBasis(const Space& space, std::vector<Factor> factors,
  std::span<const int> source, std::vector<int> modeOf)
  : TargetSpace(space)
  , Factors(std::move(factors))
  , SourceOf(source.begin(), source.end())
  , ModeOf(std::move(modeOf))
{
  std::size_t columns = 1;
  std::vector<double> norm{ 1.0 };
  for (const auto& factor : Factors)
  {
    columns *= factor.columns;
    std::vector<double> next;
    next.reserve(norm.size() * factor.rows);
    for (const double outer : norm)
    {
      for (int row = 0; row < factor.rows; ++row)
      {
        double sum = 0.0;
        for (int column = 0; column < factor.columns; ++column)
        {
          sum += std::fabs(static_cast<double>(factor.matrix[row * factor.columns + column]));
        }
        next.push_back(outer * sum);
      }
    }
    norm = std::move(next);
  }
  std::vector<bool> seen(columns, false);
  for (const int s : SourceOf)
  {
    if (SourceOf.size() != columns || s < 0 || s >= static_cast<int>(columns) || seen[s])
    {
      throw InvalidData("a change of basis needs each of its " + std::to_string(columns) +
        " source functions once; the numbering given is no permutation of them.");
    }
    seen[s] = true;
  }
  RowNorm.resize(norm.size());
  for (std::size_t i = 0; i < norm.size(); ++i)
  {
    RowNorm[ModeOf[i]] = norm[i];
  }
}

ChangeOfBasis::Factor ChangeOfBasis::Solve(int modes, int sources,
  const std::vector<long double>& modesAtPoints, const std::vector<long double>& sourcesAtPoints)
{
  Factor factor{ modes, sources, std::vector<long double>(std::size_t(modes) * sources) };
  const Map<const LongMatrix> v(modesAtPoints.data(), modes, modes);
  const Map<const LongMatrix> f(sourcesAtPoints.data(), modes, sources);
  Map<LongMatrix>(factor.matrix.data(), modes, sources) = v.partialPivLu().solve(f);
  return factor;
}

ChangeOfBasis::Factor ChangeOfBasis::LineFactor(int order, Family family)
{
  const int n = order + 1;
  std::vector<long double> modes(std::size_t(n) * n);
  std::vector<long double> sources(modes.size(), 0.0L);
  for (int i = 0; i < n; ++i)
  {
    const bool nodal = family == Family::EquispacedLagrange;
    const long double z = nodal ? Equispaced(i, order) : Chebyshev(i, order);
    HWY_NAMESPACE::FillPolynomials<false>(RecurrenceTable<long double>::Row(0), order, z,
      &modes[std::size_t(i) * n], static_cast<long double*>(nullptr));
    for (int k = 0; k < n; ++k)
    {
      sources[std::size_t(i) * n + k] = nodal
        ? static_cast<long double>(i == k)
        : Binomial(order, k) * Power((1 + z) / 2, k) * Power((1 - z) / 2, order - k);
    }
  }
  return Solve(n, n, modes, sources);
}

ChangeOfBasis::Factor ChangeOfBasis::TriangleFactor(int order, Family family)
{
  // The triangle of the prism at line order 0: modes (p, 0, r), functions of (xi1, xi3).
  const auto n = static_cast<std::uint8_t>(order);
  const Space triangle{ Shape::Prism, Form::Collapsed, { n, 0, n } };
  const int count = triangle.Modes();
  std::vector<long double> modes(std::size_t(count) * count);
  std::vector<long double> sources(modes.size(), 0.0L);
  const bool nodal = family == Family::EquispacedLagrange;
  const auto points = UnisolventPoints(triangle);
  int node = 0;
  for (int i = 0; i <= order; ++i)
  {
    for (int k = 0; k <= order - i; ++k, ++node)
    {
      const LongVec3 xi = !nodal ? points[node]
        : order == 0             ? LongVec3{ -1.0L / 3, 0, -1.0L / 3 }
                                 : LongVec3{ Equispaced(i, order), 0, Equispaced(k, order) };
      EvaluateModes(triangle, xi, &modes[std::size_t(node) * count]);
      if (nodal)
      {
        sources[std::size_t(node) * count + node] = 1.0L;
        continue;
      }
      const long double l1 = (1 + xi[0]) / 2;
      const long double l3 = (1 + xi[2]) / 2;
      int function = 0;
      for (int a = 0; a <= order; ++a)
      {
        for (int c = 0; c <= order - a; ++c, ++function)
        {
          sources[std::size_t(node) * count + function] = Binomial(order, a) *
            Binomial(order - a, c) * Power(l1, a) * Power(l3, c) *
            Power(1 - l1 - l3, order - a - c);
        }
      }
    }
  }
  return Solve(count, count, modes, sources);
}

ChangeOfBasis ChangeOfBasis::Hexahedron(
  const Space& space, Family family, std::span<const int> source)
{
  std::vector<Factor> factors;
  for (const auto order : space.order)
  {
    factors.push_back(LineFactor(order, family));
  }
  std::vector<int> modeOf(space.Modes());
  std::iota(modeOf.begin(), modeOf.end(), 0);
  return { space, std::move(factors), source, std::move(modeOf) };
}

ChangeOfBasis ChangeOfBasis::Prism(const Space& space, Family family, std::span<const int> source)
{
  const int lineOrder = space.order[1];
  std::vector<int> modeOf(space.Modes());
  // Triangle modes (p, r) are numbered p slowest, as in the space itself.
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      const int n = space.order[2];
      const int triangleMode = p * (n + 1) - p * (p - 1) / 2 + r;
      modeOf[triangleMode * (lineOrder + 1) + q] = mode;
    });
  return { space, { TriangleFactor(space.order[0], family), LineFactor(lineOrder, family) }, source,
    std::move(modeOf) };
}

ChangeOfBasis ChangeOfBasis::Tetrahedron(
  const Space& space, Family family, std::span<const int> source)
{
  const int order = space.order[0];
  const int count = space.Modes();
  std::vector<long double> modes(std::size_t(count) * count);
  std::vector<long double> sources(modes.size(), 0.0L);
  const bool nodal = family == Family::EquispacedLagrange;
  const auto points = UnisolventPoints(space);
  int node = 0;
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; j <= order - i; ++j)
    {
      for (int k = 0; k <= order - i - j; ++k, ++node)
      {
        const LongVec3 xi = !nodal ? points[node]
          : order == 0
          ? LongVec3{ -0.5L, -0.5L, -0.5L }
          : LongVec3{ Equispaced(i, order), Equispaced(j, order), Equispaced(k, order) };
        EvaluateModes(space, xi, &modes[std::size_t(node) * count]);
        long double* row = &sources[std::size_t(node) * count];
        if (nodal)
        {
          row[node] = 1.0L;
          continue;
        }
        const long double l1 = (1 + xi[0]) / 2;
        const long double l2 = (1 + xi[1]) / 2;
        const long double l3 = (1 + xi[2]) / 2;
        for (int a = 0; a <= order; ++a)
        {
          for (int b = 0; b <= order - a; ++b)
          {
            for (int c = 0; c <= order - a - b; ++c)
            {
              *row++ = Binomial(order, a) * Binomial(order - a, b) * Binomial(order - a - b, c) *
                Power(l1, a) * Power(l2, b) * Power(l3, c) *
                Power(1 - l1 - l2 - l3, order - a - b - c);
            }
          }
        }
      }
    }
  }
  std::vector<int> modeOf(count);
  std::iota(modeOf.begin(), modeOf.end(), 0);
  return { space, { Solve(count, count, modes, sources) }, source, std::move(modeOf) };
}

ChangeOfBasis ChangeOfBasis::FromFunctions(const Space& space, int sources,
  const std::function<void(const LongVec3&, long double*)>& functions)
{
  const int count = space.Modes();
  const auto points = UnisolventPoints(space);
  std::vector<long double> modes(std::size_t(count) * count);
  std::vector<long double> values(std::size_t(count) * sources);
  for (int i = 0; i < count; ++i)
  {
    EvaluateModes(space, points[i], &modes[std::size_t(i) * count]);
    functions(points[i], &values[std::size_t(i) * sources]);
  }
  Factor factor = Solve(count, sources, modes, values);
  // Functions outside of the space would be altered by the interpolation: check between the points.
  std::vector<long double> atPoint(count);
  std::vector<long double> expected(sources);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    LongVec3 xi;
    for (int d = 0; d < 3; ++d)
    {
      xi[d] = 0.3L * points[i][d] + 0.7L * points[i + 1][d];
    }
    EvaluateModes(space, xi, atPoint.data());
    functions(xi, expected.data());
    for (int s = 0; s < sources; ++s)
    {
      long double sum = -expected[s];
      for (int m = 0; m < count; ++m)
      {
        sum += factor.matrix[std::size_t(m) * sources + s] * atPoint[m];
      }
      if (!(std::fabs(sum) <= 1e-10L * std::max(1.0L, std::fabs(expected[s]))))
      {
        throw InvalidData("source function " + std::to_string(s) + " does not lie in the " +
          Name(space.shape) + "'s space of order " + std::to_string(space.MaxOrder()) + ".");
      }
    }
  }
  std::vector<int> source(sources);
  std::iota(source.begin(), source.end(), 0);
  std::vector<int> modeOf(count);
  std::iota(modeOf.begin(), modeOf.end(), 0);
  return { space, { std::move(factor) }, source, std::move(modeOf) };
}

void ChangeOfBasis::Apply(
  std::span<const double> values, double shift, std::span<double> canonical) const
{
  std::vector<long double> current(SourceOf.size());
  for (std::size_t i = 0; i < current.size(); ++i)
  {
    current[i] = static_cast<long double>(values[SourceOf[i]]) - shift;
  }
  std::vector<long double> next;
  std::size_t outer = 1; // combinations of rows of the factors already applied
  std::size_t inner = current.size();
  for (const auto& factor : Factors)
  {
    inner /= factor.columns;
    next.assign(outer * factor.rows * inner, 0.0L);
    for (std::size_t o = 0; o < outer; ++o)
    {
      for (int row = 0; row < factor.rows; ++row)
      {
        long double* to = &next[(o * factor.rows + row) * inner];
        for (int column = 0; column < factor.columns; ++column)
        {
          const long double m = factor.matrix[std::size_t(row) * factor.columns + column];
          const long double* from = &current[(o * factor.columns + column) * inner];
          for (std::size_t i = 0; i < inner; ++i)
          {
            to[i] += m * from[i];
          }
        }
      }
    }
    current.swap(next);
    outer *= factor.rows;
  }
  for (std::size_t i = 0; i < current.size(); ++i)
  {
    canonical[ModeOf[i]] = static_cast<double>(current[i]);
  }
}
} // namespace pixelexact
