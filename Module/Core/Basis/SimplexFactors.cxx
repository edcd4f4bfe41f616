// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/SimplexFactors.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pixelexact
{
namespace
{
long double Power(long double base, int exponent)
{
  long double result = 1.0L;
  for (int k = 0; k < exponent; ++k)
  {
    result *= base;
  }
  return result;
}

long double LongBinomial(int n, int k)
{
  long double result = 1.0L;
  for (int i = 1; i <= k; ++i)
  {
    result = result * (n - k + i) / i;
  }
  return result;
}
} // namespace

NodeFamily NodesOf(Family family)
{
  return family == Family::GaussLobattoLagrange ? NodeFamily::GaussLobatto : NodeFamily::Equispaced;
}

BasisFactor TriangleFactor(int order, Family family)
{
  // The triangle of the prism at line order 0: modes (p, 0, r), functions of (xi1, xi3).
  const auto n = static_cast<std::uint8_t>(order);
  const Space triangle{ Shape::Prism, Form::Collapsed, { n, 0, n } };
  const int count = triangle.Modes();
  std::vector<long double> modes(std::size_t(count) * count);
  std::vector<long double> sources(modes.size(), 0.0L);
  const bool nodal = family != Family::Bernstein;
  const auto points = UnisolventPoints(triangle);
  const SimplexNodes nodes(order, NodesOf(family));
  int node = 0;
  for (int i = 0; i <= order; ++i)
  {
    for (int k = 0; k <= order - i; ++k, ++node)
    {
      const LongVec3 xi = !nodal ? points[node]
        : order == 0
        ? LongVec3{ -1.0L / 3, 0, -1.0L / 3 }
        : LongVec3{ nodes.At(i, { k, order - i - k }), 0, nodes.At(k, { i, order - i - k }) };
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
          sources[std::size_t(node) * count + function] = LongBinomial(order, a) *
            LongBinomial(order - a, c) * Power(l1, a) * Power(l3, c) *
            Power(1 - l1 - l3, order - a - c);
        }
      }
    }
  }
  BasisFactor factor = SolveFactor(count, count, modes, sources);
  factor.space = triangle;
  return factor;
}

BasisFactor TetrahedronFactor(const Space& space, Family family)
{
  const int order = space.order[0];
  const int count = space.Modes();
  std::vector<long double> modes(std::size_t(count) * count);
  std::vector<long double> sources(modes.size(), 0.0L);
  const bool nodal = family != Family::Bernstein;
  const auto points = UnisolventPoints(space);
  const SimplexNodes nodes(order, NodesOf(family));
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
          : LongVec3{ nodes.At(i, { j, k, order - i - j - k }),
              nodes.At(j, { i, k, order - i - j - k }), nodes.At(k, { i, j, order - i - j - k }) };
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
              *row++ = LongBinomial(order, a) * LongBinomial(order - a, b) *
                LongBinomial(order - a - b, c) * Power(l1, a) * Power(l2, b) * Power(l3, c) *
                Power(1 - l1 - l2 - l3, order - a - b - c);
            }
          }
        }
      }
    }
  }
  BasisFactor factor = SolveFactor(count, count, modes, sources);
  factor.space = space;
  return factor;
}
} // namespace pixelexact
