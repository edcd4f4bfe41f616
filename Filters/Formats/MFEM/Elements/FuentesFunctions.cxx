// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/FuentesFunctions.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pixelexact::mfem
{
namespace
{
using Values = std::vector<long double>;

/// t^i P_i(2 x / t - 1), i <= order; P Legendre's polynomials.
Values ScaledLegendre(int order, long double x, long double t)
{
  Values values(order + 1, 1.0L);
  const long double z = 2 * x - t;
  for (int i = 1; i <= order; ++i)
  {
    const long double before = i > 1 ? values[i - 2] : 0.0L;
    values[i] = ((2 * i - 1) * z * values[i - 1] - (i - 1) * t * t * before) / i;
  }
  return values;
}

/// Edge functions i = 2, 3, ..., order, homogeneous of degree i in the coordinates of the two ends:
/// integrals of Legendre's polynomials. Entries 0 and 1 are empty.
Values EdgeFunctions(int order, long double from, long double to)
{
  const long double t = from + to;
  Values values = ScaledLegendre(order, to, t);
  for (int i = order; i >= 2; --i)
  {
    values[i] = (values[i] - t * t * values[i - 2]) / (4 * i - 2);
  }
  return values;
}
} // namespace

LongVec3 InTensorSpace(const LongVec3& xi)
{
  const long double width = (1 - xi[2]) / 2;
  if (width == 0)
  {
    return { -1, -1, 1 };
  }
  return { (1 + xi[0]) / width - 1, (1 + xi[1]) / width - 1, xi[2] };
}

void FuentesFunctions::Evaluate(const LongVec3& xi, long double* values) const
{
  const LongVec3 eta = InTensorSpace(xi);
  const int p = Order;
  // Coordinates that run from zero to one.
  const std::array<long double, 2> xs{ (1 - eta[0]) / 2, (1 + eta[0]) / 2 };
  const std::array<long double, 2> ys{ (1 - eta[1]) / 2, (1 + eta[1]) / 2 };
  const long double z = (1 + eta[2]) / 2;
  const long double low = 1 - z;
  for (int b = 0; b < 2; ++b)
  {
    for (int a = 0; a < 2; ++a)
    {
      const long double vertex = xs[a] * ys[b] * low;
      *values++ = vertex;
      const auto upright = EdgeFunctions(p, vertex, z);
      values = std::copy(upright.begin() + 2, upright.end(), values);
    }
  }
  *values++ = z;
  const auto alongX = EdgeFunctions(p, xs[0], xs[1]);
  const auto alongY = EdgeFunctions(p, ys[0], ys[1]);
  const auto alongZ = EdgeFunctions(p, low, z);
  const auto heights = ScaledLegendre(p, z, 1.0L);
  long double narrowed = low; // low^i
  for (int i = 2; i <= p; ++i)
  {
    narrowed *= low;
    for (int c = 0; c < 2; ++c)
    {
      const long double onX = ys[c] * narrowed * alongX[i];
      const long double onY = xs[c] * narrowed * alongY[i];
      *values++ = onX;
      *values++ = onY;
      for (int j = 1; i + j <= p; ++j)
      {
        *values++ = onX * z * heights[j - 1];
        *values++ = onY * z * heights[j - 1];
      }
    }
    for (int j = 2; j <= p; ++j)
    {
      const long double layer = alongX[i] * alongY[j];
      *values++ = low * layer;
      for (int k = 2; k <= p; ++k)
      {
        *values++ = layer * alongZ[k];
      }
    }
  }
}
} // namespace pixelexact::mfem
