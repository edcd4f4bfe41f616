// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/PyramidPlace.h"

namespace pixelexact::mfem
{
LongVec3 Cross(const LongVec3& a, const LongVec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

LongVec3 Sum(long double f, const LongVec3& a, long double g, const LongVec3& b)
{
  return { f * a[0] + g * b[0], f * a[1] + g * b[1], f * a[2] + g * b[2] };
}

long double Power(long double base, int exponent)
{
  long double power = 1.0L;
  for (int i = 0; i < exponent; ++i)
  {
    power *= base;
  }
  return power;
}

std::vector<long double> ScaledJacobi(int order, int alpha, long double x, long double t)
{
  std::vector<long double> values(order + 1, 1.0L);
  if (order > 0)
  {
    values[1] = (2 + alpha) * x - t;
  }
  for (int i = 2; i <= order; ++i)
  {
    const long double n = 2 * i + alpha;
    const long double now = (n - 1) * (n * (n - 2) * (2 * x - t) + alpha * alpha * t);
    const long double before = 2 * (alpha + i - 1) * (i - 1) * n * t * t;
    values[i] = (now * values[i - 1] - before * values[i - 2]) / (2 * i * (alpha + i) * (n - 2));
  }
  return values;
}

LinePlace::LinePlace(int order, long double s)
  : hat{ 1 - s, s }
  , legendre(ScaledJacobi(order, 0, s, 1))
  , bubble(order + 1, 0.0L)
{
  for (int i = 2; i <= order; ++i)
  {
    bubble[i] = (legendre[i] - legendre[i - 2]) / (4 * i - 2);
  }
}

PyramidPlace::PyramidPlace(int order, const LongVec3& unit)
  : z(unit[2])
  , width(1 - z)
  , across{ LinePlace(order, unit[0] / width), LinePlace(order, unit[1] / width) }
  , height(order, z)
  , frame{ { { 1, 0, unit[0] / width }, { 0, 1, unit[1] / width } } }
  , normal(Cross(frame[0], frame[1]))
{
}

LongVec3 PyramidPlace::VertexSlope(int a, int b) const
{
  const long double x = across[0].hat[a];
  const long double y = across[1].hat[b];
  return Sum(1, Sum(a == 0 ? -y : y, frame[0], b == 0 ? -x : x, frame[1]), -x * y, kUpwards);
}
} // namespace pixelexact::mfem
