// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/NodalFunctions.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <utility>

namespace pixelexact::mfem
{
namespace
{
/// Both ends, and the middles between Gauss's points.
std::vector<long double> ClosedGaussPoints(int n)
{
  std::vector<long double> points{ -1.0L };
  if (n > 2)
  {
    const auto gauss = GaussPoints(n - 1);
    for (int i = 0; i + 2 < n; ++i)
    {
      points.push_back((gauss[i] + gauss[i + 1]) / 2);
    }
  }
  points.push_back(1.0L);
  return points;
}

/// (first + 2 i) / last - 1
std::vector<long double> Equispaced(int n, int first, int last)
{
  std::vector<long double> points(n);
  for (int i = 0; i < n; ++i)
  {
    points[i] = static_cast<long double>(first + 2 * i) / last - 1.0L;
  }
  return points;
}
} // namespace

std::vector<long double> LinePoints(LineBasis basis, int n)
{
  if (n == 1)
  {
    return { 0.0L };
  }
  switch (basis)
  {
    case LineBasis::GaussLegendre:
      return GaussPoints(n);
    case LineBasis::GaussLobatto:
      return GaussLobattoPoints(n);
    case LineBasis::OpenUniform:
      return Equispaced(n, 2, n + 1);
    case LineBasis::ClosedUniform:
      return ClosedUniformPoints(n);
    case LineBasis::OpenHalfUniform:
      return Equispaced(n, 1, n);
    case LineBasis::ClosedGaussLegendre:
      return ClosedGaussPoints(n);
    default:
      throw Unsupported("there are no nodes of " + Describe(basis) + ".");
  }
}

LineFunctions LineOf(LineBasis basis, int count)
{
  return basis == LineBasis::Positive ? Bernstein(count - 1) : Lagrange(LinePoints(basis, count));
}

LineFunctions Mirrored(LineFunctions line)
{
  const int count = line.count;
  return { count,
    [inner = std::move(line.evaluate)](long double z, long double* values) { inner(-z, values); } };
}

LineFunctions Times(long double factor, LineFunctions line)
{
  const int count = line.count;
  return { count,
    [inner = std::move(line.evaluate), factor, count](long double z, long double* values)
    {
      inner(z, values);
      std::for_each(values, values + count, [factor](long double& value) { value *= factor; });
    } };
}

std::vector<long double> DualMatrix(int count, const std::vector<long double>& functionals)
{
  std::vector<long double> identity(functionals.size(), 0.0L);
  for (int i = 0; i < count; ++i)
  {
    identity[std::size_t(i) * count + i] = 1.0L;
  }
  return SolveFactor(count, count, functionals, identity).matrix;
}

SolidFunctions Combined(
  SolidFunctions functions, int terms, std::vector<long double> matrix, int count)
{
  return [inner = std::move(functions), terms, matrix = std::move(matrix), count](
           const LongVec3& xi, long double* values)
  {
    std::vector<long double> term(terms);
    inner(xi, term.data());
    std::fill(values, values + count, 0.0L);
    for (int m = 0; m < terms; ++m)
    {
      for (int j = 0; j < count; ++j)
      {
        values[j] += term[m] * matrix[std::size_t(m) * count + j];
      }
    }
  };
}

SolidFunctions Cardinal(const Space& space, const std::vector<LongVec3>& nodes)
{
  const int count = space.Modes();
  std::vector<long double> functionals(std::size_t(count) * count);
  for (int k = 0; k < count; ++k)
  {
    EvaluateModes(space, nodes[k], &functionals[std::size_t(k) * count]);
  }
  return Combined([space](const LongVec3& xi, long double* values)
    { EvaluateModes(space, xi, values); },
    count, DualMatrix(count, functionals), count);
}
} // namespace pixelexact::mfem
