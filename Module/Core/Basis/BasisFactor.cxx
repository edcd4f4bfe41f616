// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/BasisFactor.h"

#include "Core/Base/Error.h"
#include "Core/Basis/Modes-inl.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact
{
namespace
{
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Map;

/// Functions with a smaller misfit count as members of the space. Interpolation would change
/// others.
constexpr long double kLargestMisfit = 1e-10L;
/// A point in [-1,1] that is a node of no rule.
constexpr long double kCheckPoint = 0.8371952603L;

template <template <class, class, bool> class Modes>
void Evaluate(const Space& space, const LongVec3& xi, long double* out)
{
  const Modes<long double, HWY_NAMESPACE::AnyOrder, false> modes(
    space, HWY_NAMESPACE::Point<long double>{ { xi[0], xi[1], xi[2] } });
  ForEachMode(space, [&](int p, int q, int r, int mode) { out[mode] = modes.Mode(p, q, r); });
}

/// Chebyshev's points in [-1,1]: well conditioned at every order.
long double Chebyshev(int i, int order)
{
  return -std::cos(std::numbers::pi_v<long double> * (2 * i + 1) / (2 * (order + 1)));
}

/// The largest relative difference between the functions and their expansion at a point.
long double Misfit(const BasisFactor& factor, const std::vector<long double>& modes,
  const std::vector<long double>& expected, int* worst)
{
  long double largest = -1.0L;
  for (int s = 0; s < factor.columns; ++s)
  {
    long double sum = -expected[s];
    for (int m = 0; m < factor.rows; ++m)
    {
      sum += factor.matrix[std::size_t(m) * factor.columns + s] * modes[m];
    }
    const long double misfit = std::fabs(sum) / std::max(1.0L, std::fabs(expected[s]));
    if (!(misfit <= largest))
    {
      largest = misfit;
      *worst = s;
    }
  }
  return largest;
}
} // namespace

std::vector<LongVec3> UnisolventPoints(const Space& space)
{
  std::vector<LongVec3> points;
  points.reserve(space.Modes());
  const auto [P, Q, R] = space.order;
  ForEachMode(space,
    [&, P = P, Q = Q, R = R](int p, int q, int r, int /*mode*/)
    {
      // The layer of q and r has fewer values of p: spread its points over [-1,1].
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

BasisFactor SolveFactor(int modes, int sources, const std::vector<long double>& modesAtPoints,
  const std::vector<long double>& sourcesAtPoints)
{
  BasisFactor factor{ modes, sources, std::vector<long double>(std::size_t(modes) * sources) };
  const Map<const LongMatrix> v(modesAtPoints.data(), modes, modes);
  const Map<const LongMatrix> f(sourcesAtPoints.data(), modes, sources);
  Map<LongMatrix>(factor.matrix.data(), modes, sources) = v.partialPivLu().solve(f);
  return factor;
}

BasisFactor LineFactor(int order, const LineFunctions& line)
{
  const int n = order + 1;
  // The last point checks the factor that the other points determine.
  std::vector<long double> modes(std::size_t(n + 1) * n);
  std::vector<long double> values(std::size_t(n + 1) * line.count);
  for (int i = 0; i <= n; ++i)
  {
    const long double z = i < n ? Chebyshev(i, order) : kCheckPoint;
    HWY_NAMESPACE::FillPolynomials<false>(RecurrenceTable<long double>::Row(0), order, z,
      &modes[std::size_t(i) * n], static_cast<long double*>(nullptr));
    line.evaluate(z, &values[std::size_t(i) * line.count]);
  }
  BasisFactor factor = SolveFactor(n, line.count, modes, values);
  factor.space = { Shape::Hexahedron, Form::Collapsed, { static_cast<std::uint8_t>(order), 0, 0 } };
  modes.erase(modes.begin(), modes.end() - n);
  values.erase(values.begin(), values.end() - line.count);
  int worst = 0;
  if (!(Misfit(factor, modes, values, &worst) <= kLargestMisfit))
  {
    throw InvalidData("line function " + std::to_string(worst) + " is no polynomial of order " +
      std::to_string(order) + " or less.");
  }
  return factor;
}

BasisFactor SolidFactor(const Space& space, int count,
  const std::function<void(const LongVec3&, long double*)>& functions)
{
  const int rows = space.Modes();
  const auto points = UnisolventPoints(space);
  std::vector<long double> modes(std::size_t(rows) * rows);
  std::vector<long double> values(std::size_t(rows) * count);
  for (int i = 0; i < rows; ++i)
  {
    EvaluateModes(space, points[i], &modes[std::size_t(i) * rows]);
    functions(points[i], &values[std::size_t(i) * count]);
  }
  BasisFactor factor = SolveFactor(rows, count, modes, values);
  factor.space = space;
  // The check at a point between the nodes.
  std::vector<long double> atPoint(rows);
  std::vector<long double> expected(count);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    LongVec3 xi;
    for (int d = 0; d < 3; ++d)
    {
      xi[d] = 0.3L * points[i][d] + 0.7L * points[i + 1][d];
    }
    EvaluateModes(space, xi, atPoint.data());
    functions(xi, expected.data());
    int worst = 0;
    if (!(Misfit(factor, atPoint, expected, &worst) <= kLargestMisfit))
    {
      throw InvalidData("source function " + std::to_string(worst) + " does not lie in the " +
        Name(space.shape) + "'s space of order " + std::to_string(space.MaxOrder()) + ".");
    }
  }
  return factor;
}
} // namespace pixelexact
