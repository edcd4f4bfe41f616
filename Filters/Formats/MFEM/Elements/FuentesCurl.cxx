// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/FuentesVectors.h"

#include "Formats/MFEM/Elements/PyramidPlace.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
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
} // namespace pixelexact::mfem
