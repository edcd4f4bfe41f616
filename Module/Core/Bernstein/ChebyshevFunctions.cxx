// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/ChebyshevModel.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Steps of Newton's iteration, which doubles the digits.
constexpr int kDoublingSteps = 7;

} // namespace

ChebyshevModel Reciprocal(const ChebyshevModel& f)
{
  ChebyshevModel unknown;
  unknown.error = kInfinity;
  if (f.Range().Contains(0.0))
  {
    return unknown;
  }
  const ChebyshevModel p = f.Polynomial();
  ChebyshevModel r(1.0 / f.c[0]);
  for (int step = 0; step < kDoublingSteps; ++step)
  {
    const ChebyshevModel left = ChebyshevModel(1.0) - p * r;
    r = (r + r * left).Polynomial();
    if (left.Norm() < 1e-9)
    {
      break;
    }
  }
  // 1/f = r / (1 - d) with d = 1 - f r.
  const double d = (ChebyshevModel(1.0) - f * r).Range().Magnitude();
  if (!(d < 1.0))
  {
    return unknown;
  }
  r.error = Up(r.Range().Magnitude() * d / (1.0 - d));
  return r;
}

ChebyshevModel SquareRoot(const ChebyshevModel& f)
{
  ChebyshevModel unknown;
  unknown.error = kInfinity;
  const double least = f.Range().lower;
  if (!(least > 0.0))
  {
    return unknown;
  }
  // Newton's iteration for 1 / sqrt(f), which needs no quotients.
  const ChebyshevModel p = f.Polynomial();
  ChebyshevModel r(1.0 / std::sqrt(f.c[0]));
  for (int step = 0; step < kDoublingSteps; ++step)
  {
    const ChebyshevModel left = ChebyshevModel(1.0) - p * (r * r);
    r = (r + 0.5 * (r * left)).Polynomial();
    if (left.Norm() < 1e-9)
    {
      break;
    }
  }
  ChebyshevModel s = (p * r).Polynomial();
  // sqrt(f) - s = (f - s^2) / (sqrt(f) + s).
  if (!(s.Range().lower > 0.0))
  {
    return unknown;
  }
  s.error = Up((f - s * s).Range().Magnitude() / std::sqrt(least) * (1.0 + 0x1p-40));
  return s;
}

void AddRoughness(const ChebyshevModel& model, std::array<double, 2>& along)
{
  /// Lower terms decide where there are no higher ones.
  constexpr double kLower = 1e-9;
  constexpr int kHighest = 3;
  const double scale = 1.0 / (model.Norm() + 0x1p-1000);
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      const double size = scale * std::fabs(model.c[ChebyshevModel::Index(i, j)]) *
        (i + j > ChebyshevModel::kDegree - kHighest ? 1.0 : kLower);
      along[0] += size * i;
      along[1] += size * j;
    }
  }
}

bool IsRange(const ChebyshevModel& model)
{
  constexpr double kRounding = 1e-10;
  const double size = model.Norm();
  std::array<double, 2> along{ 0.0, 0.0 };
  AddRoughness(model, along);
  return model.error > size * std::max(along[0] + along[1], kRounding);
}
} // namespace pixelexact
