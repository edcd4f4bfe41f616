// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/NodalFunctions.h"

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

/// The derivative at z of Lagrange's polynomial of point `at`.
long double LagrangeSlope(const std::vector<long double>& points, std::size_t at, long double z)
{
  long double slope = 0.0L;
  for (std::size_t left = 0; left < points.size(); ++left)
  {
    if (left == at)
    {
      continue;
    }
    long double product = 1 / (points[at] - points[left]);
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      if (k != at && k != left)
      {
        product *= (z - points[k]) / (points[at] - points[k]);
      }
    }
    slope += product;
  }
  return slope;
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
    case LineBasis::IntegratedGaussLobatto:
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

LineFunctions IntegratedOf(LineBasis closed, int count)
{
  return { count,
    [points = LinePoints(closed, count + 1), count](long double z, long double* values)
    {
      long double sum = 0.0L;
      for (int i = 0; i < count; ++i)
      {
        sum -= 2 * LagrangeSlope(points, i, z);
        values[i] = sum;
      }
    } };
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
} // namespace pixelexact::mfem
