// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/MonotoneRim.h"

#include "Core/Bernstein/ChebyshevBasis.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// The distance beyond [-1, 1] that a rim's model may reach.
constexpr double kBeyondSquare = 1e-3;
/// Errors of an end whose values count as zero. Every number is proven, because `strip` holds what
/// such values leave open. Where the function is zero at the end, its coefficients there are within
/// one error of zero and their hull adds another one; a factor of 2 remains for the roundings of
/// subdivision, so that a rim that lies in the end is decided and not subdivided to the last level.
constexpr double kZeroInEndErrors = 4.0;
constexpr int kBisections = 50;
constexpr int kEndSteps = 12;

std::array<double, ChebyshevModel::kDegree + 1> Values(double s)
{
  std::array<double, ChebyshevModel::kDegree + 1> values{ 1.0, s };
  for (std::size_t n = 2; n < values.size(); ++n)
  {
    values[n] = 2.0 * s * values[n - 1] - values[n - 2];
  }
  return values;
}

double ValueAt(const ChebyshevModel& f, double s, double t)
{
  const auto a = Values(s);
  const auto b = Values(t);
  double sum = 0.0;
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      sum += f.c[ChebyshevModel::Index(i, j)] * a[static_cast<std::size_t>(i)] *
        b[static_cast<std::size_t>(j)];
    }
  }
  return sum;
}

/// The function at t = end, -1 or 1, in Bernstein form of s.
BoxPolynomial AtEnd(const ChebyshevModel& f, double end)
{
  const ChebyshevInBernstein& basis = ChebyshevInBernstein::Get();
  BoxPolynomial line{ { ChebyshevModel::kDegree, 0, 0 },
    std::vector<double>(ChebyshevModel::kDegree + 1, 0.0), 0.0 };
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    double sum = 0.0;
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      sum += (j % 2 == 0 ? 1.0 : end) * f.c[ChebyshevModel::Index(i, j)];
    }
    for (std::size_t k = 0; k < line.b.size(); ++k)
    {
      line.b[k] += sum * basis.column[static_cast<std::size_t>(i)][k];
    }
  }
  line.error = Up(f.error + Gamma(4 * ChebyshevModel::kDegree + 8) * basis.largest * f.Norm());
  return line;
}
} // namespace

std::optional<MonotoneRim> MonotoneRim::Of(const ChebyshevModel& function)
{
  MonotoneRim rim;
  rim.Function = function;
  rim.Slope = function.Polynomial().ByT();
  const Interval range = rim.Slope.TightRange();
  // Within kBeyondSquare of the square the slope changes by at most its derivative times that
  // distance. Derivatives of Chebyshev polynomials are below 1.1 j^2 there.
  double bend = 0.0;
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      bend += 1.1 * j * j * std::fabs(rim.Slope.c[ChebyshevModel::Index(i, j)]);
    }
  }
  rim.Steepness = (range.Mignitude() - kBeyondSquare * bend) * (1.0 - 0x1p-40);
  if (!(rim.Steepness > 0.0))
  {
    return std::nullopt;
  }
  rim.Sign = range.lower > 0.0 ? 1.0 : -1.0;
  const RimEnds ends = rim.Ends();
  rim.Tolerance = kZeroInEndErrors * std::max(ends.low.error, ends.high.error);
  return rim;
}

RimEnds MonotoneRim::Ends() const
{
  return { AtEnd(Function, -1.0), AtEnd(Function, 1.0) };
}

RimKind MonotoneRim::KindOf(const RimEnds& ends, double& strip) const
{
  // Seen from where it is least.
  const Interval least = (IsUpper() ? ends.low : ends.high).Hull();
  const Interval most = (IsUpper() ? ends.high : ends.low).Hull();
  const double wide = Up((Tolerance + Function.error) / Steepness);
  if (least.lower >= -Tolerance)
  {
    strip = least.lower > 0.0 ? 0.0 : wide;
    return RimKind::NothingIn;
  }
  if (most.upper <= Tolerance)
  {
    strip = most.upper < 0.0 ? 0.0 : wide;
    return RimKind::AllIn;
  }
  return least.upper < 0.0 && most.lower > 0.0 ? RimKind::Crosses : RimKind::Undecided;
}

double MonotoneRim::RootAt(double s) const
{
  double from = -1.0;
  double to = 1.0;
  for (int step = 0; step < kBisections; ++step)
  {
    const double middle = 0.5 * (from + to);
    (Sign * ValueAt(Function, s, middle) < 0.0 ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

std::optional<ChebyshevModel> MonotoneRim::Between(
  double from, double to, const Composition& compose) const
{
  const double start = RootAt(from);
  const double middle = RootAt(0.5 * (from + to));
  const double end = RootAt(to);
  ChebyshevModel x(0.25 * start + 0.5 * middle + 0.25 * end);
  x.c[ChebyshevModel::Index(1, 0)] = 0.5 * (end - start);
  x.c[ChebyshevModel::Index(2, 0)] = 0.25 * start - 0.5 * middle + 0.25 * end;
  const ChebyshevModel f = Function.Polynomial();
  const ChebyshevModel slope = Slope.Polynomial();
  double before = std::numeric_limits<double>::infinity();
  ChebyshevModel inverse;
  for (int step = 0; step < kEndSteps; ++step)
  {
    const ChebyshevModel left = compose(f, x);
    const double miss = left.Norm();
    if (!(miss < 0.5 * before))
    {
      break;
    }
    before = miss;
    if (step < 3)
    {
      const ChebyshevModel by = compose(slope, x).Polynomial();
      inverse = step == 0 ? ChebyshevModel(1.0 / by.c[0]) : inverse;
      inverse = (inverse + inverse * (ChebyshevModel(1.0) - by * inverse)).Polynomial();
    }
    x = (x - left.Polynomial() * inverse).Polynomial();
  }
  x.error = Up((compose(f, x).Range().Magnitude() + Function.error) / Steepness);
  const bool near = x.TightRange().Magnitude() <= 1.0 + kBeyondSquare;
  return near ? std::optional(x) : std::nullopt;
}
} // namespace pixelexact
