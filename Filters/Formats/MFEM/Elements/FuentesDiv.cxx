// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/FuentesVectors.h"

#include "Formats/MFEM/Elements/PyramidPlace.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
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
      // With the cross product of the gradient of `side` and the frame's vector: + or - normal.
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
