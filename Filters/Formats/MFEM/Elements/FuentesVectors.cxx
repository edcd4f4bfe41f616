// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/VectorSpaces.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
// Components of the vector functions on MFEM's unit pyramid. Fuentes, Keith, Demkowicz and Nagaraj:
// Orientation embedded high order shape functions for the exact sequence elements of all shapes,
// 2015.

/// The polynomials of one tensor coordinate s in [0,1].
struct LinePlace
{
  LinePlace(int order, long double s);

  /// The derivative of bubble i.
  [[nodiscard]] long double Slope(int i) const { return legendre[i - 1]; }

  std::array<long double, 2> hat;
  std::vector<long double> legendre;
  /// From index 2 on: integrals of Legendre's polynomials, zero at both ends.
  std::vector<long double> bubble;
};

/// A point of the pyramid in tensor coordinates: across 0 and 1, and the height.
struct PyramidPlace
{
  PyramidPlace(int order, const LongVec3& unit);

  /// The gradient of width times hat a of the first coordinate times hat b of the second.
  [[nodiscard]] LongVec3 VertexSlope(int a, int b) const;

  long double z;
  long double width;
  std::array<LinePlace, 2> across;
  LinePlace height;
  std::array<LongVec3, 2> frame; ///< the gradients of the coordinates across, times the width
  LongVec3 normal;               ///< their cross product
};

constexpr LongVec3 kUpwards{ 0, 0, 1 };

/// f a + g b
LongVec3 Sum(long double f, const LongVec3& a, long double g, const LongVec3& b)
{
  return { f * a[0] + g * b[0], f * a[1] + g * b[1], f * a[2] + g * b[2] };
}

/// Takes functions one by one.
class VectorWriter
{
public:
  explicit VectorWriter(LongVec3* values)
    : Values(values)
  {
  }
  void Put(long double factor, const LongVec3& a) { *Values++ = Sum(factor, a, 0, a); }
  void Put(const LongVec3& a) { *Values++ = a; }

private:
  LongVec3* Values;
};

long double Power(long double base, int exponent)
{
  long double power = 1.0L;
  for (int i = 0; i < exponent; ++i)
  {
    power *= base;
  }
  return power;
}

/// t^i P_i^(alpha,0)(2 x / t - 1), i <= order; P Jacobi's polynomials, Legendre's for alpha = 0.
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

void CurlEdges(int p, const PyramidPlace& at, VectorWriter& writer)
{
  for (int d = 0; d < 2; ++d)
  {
    for (const long double beside : at.across[1 - d].hat)
    {
      for (int i = 0; i < p; ++i)
      {
        writer.Put(beside * Power(at.width, i + 1) * at.across[d].legendre[i], at.frame[d]);
      }
    }
  }
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      const long double vertex = at.width * at.across[0].hat[a] * at.across[1].hat[b];
      const LongVec3 whirl = Sum(vertex, kUpwards, -at.z, at.VertexSlope(a, b));
      for (const long double along : ScaledJacobi(p - 1, 0, at.z, vertex + at.z))
      {
        writer.Put(along, whirl);
      }
    }
  }
}

void CurlFaces(int p, const PyramidPlace& at, VectorWriter& writer)
{
  for (int d = 0; d < 2; ++d)
  {
    const LinePlace& along = at.across[d];
    const LinePlace& beside = at.across[1 - d];
    LongVec3 whirl{ 0, 0, at.width * along.hat[1] };
    whirl[d] = -at.z;
    const auto upright = ScaledJacobi(p - 1, 0, at.z, at.width * along.hat[1] + at.z);
    const long double opposite = at.width * along.hat[0];
    const auto inwards = ScaledJacobi(p - 1, 0, opposite, 1);
    for (int i = 0; i < p; ++i)
    {
      for (int j = 2; j <= p; ++j)
      {
        writer.Put(at.width * beside.bubble[j] * along.legendre[i], at.frame[d]);
      }
      for (int j = 1; i + j < p; ++j)
      {
        for (const long double side : beside.hat)
        {
          writer.Put(
            side * Power(at.width, i + 1) * along.legendre[i] * at.z * at.height.legendre[j - 1],
            at.frame[d]);
          writer.Put(side * upright[i] * opposite * inwards[j - 1], whirl);
        }
      }
    }
  }
}

void CurlInside(int p, const PyramidPlace& at, VectorWriter& writer)
{
  const auto& [x, y] = at.across;
  for (int i = 2; i <= p; ++i)
  {
    for (int j = 2; j <= p; ++j)
    {
      const long double layer = x.bubble[i] * y.bubble[j];
      const LongVec3 slope =
        Sum(x.Slope(i) * y.bubble[j], at.frame[0], x.bubble[i] * y.Slope(j), at.frame[1]);
      writer.Put(Power(at.width, std::max(i, j) - 1) * layer, kUpwards);
      for (int k = 2; k <= p; ++k)
      {
        writer.Put(
          Sum(at.height.bubble[k] / at.width, slope, layer * at.height.Slope(k), kUpwards));
      }
    }
  }
  for (int k = 2; k <= p; ++k)
  {
    for (int j = 2; j <= p; ++j)
    {
      for (int i = 0; i < p; ++i)
      {
        writer.Put(x.legendre[i] * y.bubble[j] * at.height.bubble[k], at.frame[0]);
        writer.Put(y.legendre[i] * x.bubble[j] * at.height.bubble[k], at.frame[1]);
      }
    }
  }
}

void DivFaces(int p, const PyramidPlace& at, VectorWriter& writer)
{
  for (int i = 0; i < p; ++i)
  {
    for (int j = 0; j < p; ++j)
    {
      writer.Put(at.width * at.across[0].legendre[i] * at.across[1].legendre[j], at.normal);
    }
  }
  for (int d = 0; d < 2; ++d)
  {
    const LinePlace& along = at.across[d];
    const LongVec3 outwards = Cross(at.frame[d], kUpwards);
    for (int c = 0; c < 2; ++c)
    {
      const long double side = at.across[1 - d].hat[c];
      // Uses the cross product of the gradient of `side` and the frame's vector, which is + or -
      // normal.
      const LongVec3 lean = Sum(side, outwards, c == d ? at.z : -at.z, at.normal);
      for (int i = 0; i < p; ++i)
      {
        const auto straight = ScaledJacobi(p - 1 - i, 2 * i + 1, at.z, 1);
        const auto narrowed = ScaledJacobi(p - 1 - i, 2 * i + 1, at.z, side * at.width + at.z);
        const long double first = Power(at.width, i) * along.legendre[i];
        for (int j = 0; i + j < p; ++j)
        {
          writer.Put(first, Sum(side * straight[j], outwards, Power(side, i) * narrowed[j], lean));
        }
      }
    }
  }
}

/// Curls of what vanishes on all faces.
void DivCurls(int p, const PyramidPlace& at, VectorWriter& writer)
{
  for (int d = 0; d < 2; ++d)
  {
    const LinePlace& along = at.across[d];
    const LinePlace& beside = at.across[1 - d];
    const LongVec3 upright = Cross(kUpwards, at.frame[d]);
    const long double turn = d == 0 ? -1 : 1;
    for (int k = 2; k <= p; ++k)
    {
      const long double narrow = at.height.bubble[k] / at.width;
      for (int j = 2; j <= p; ++j)
      {
        for (int i = 0; i < p; ++i)
        {
          writer.Put(along.legendre[i],
            Sum(beside.bubble[j] * (at.height.Slope(k) - narrow), upright,
              turn * beside.Slope(j) * narrow, at.normal));
        }
      }
    }
  }
}

void DivInside(int p, const PyramidPlace& at, VectorWriter& writer)
{
  const auto& [x, y] = at.across;
  const LongVec3 first = Cross(kUpwards, at.frame[0]);
  const LongVec3 second = Cross(kUpwards, at.frame[1]);
  for (int k = 2; k <= p; ++k)
  {
    for (int i = 0; i < p; ++i)
    {
      for (int j = 0; j < p; ++j)
      {
        writer.Put(x.legendre[i] * y.legendre[j] * at.height.bubble[k], at.normal);
      }
    }
  }
  for (int i = 2; i <= p; ++i)
  {
    const long double rise = Power(at.z, i - 1);
    writer.Put(rise, Sum(x.Slope(i), at.normal, -2 * x.bubble[i], second));
    writer.Put(rise, Sum(-y.Slope(i), at.normal, -2 * y.bubble[i], first));
    for (int j = 2; j <= p; ++j)
    {
      const int n = std::max(i, j);
      const long double dx = x.Slope(i) * y.bubble[j];
      const long double dy = x.bubble[i] * y.Slope(j);
      writer.Put(Power(at.width, n - 2), Sum(-dx, first, -dy, second));
      writer.Put(Power(at.z, n - 1),
        Sum(x.Slope(i) * y.Slope(j), at.normal, 1, Sum(dx, first, -dy, second)));
    }
  }
}
} // namespace

VectorSpace FuentesCurl(int order)
{
  return { order * (3 * order * order + 5),
    [order](const LongVec3& unit, LongVec3* values)
    {
      const PyramidPlace at(order, unit);
      VectorWriter writer(values);
      CurlEdges(order, at, writer);
      CurlFaces(order, at, writer);
      CurlInside(order, at, writer);
    } };
}

VectorSpace FuentesDiv(int order)
{
  const int p = order + 1;
  return { p * (3 * p * p + 2),
    [p](const LongVec3& unit, LongVec3* values)
    {
      const PyramidPlace at(p, unit);
      VectorWriter writer(values);
      DivFaces(p, at, writer);
      DivCurls(p, at, writer);
      DivInside(p, at, writer);
    } };
}
} // namespace pixelexact::mfem
