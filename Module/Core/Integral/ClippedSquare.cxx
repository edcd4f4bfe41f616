// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/ClippedSquare.h"

#include "Core/Integral/MonotoneRim.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Stretches of s are not subdivided below this width.
constexpr double kNarrowestStretch = 0x1p-40;
/// The limit of visited stretches; a few crossings need fewer. Beyond it, subdivision of the square
/// is cheaper.
constexpr int kMaxStretches = 2000;
/// A function counts as zero throughout if its range is within this many errors of zero: its
/// polynomial is within one error of zero, and its range adds another one.
constexpr double kZeroInErrors = 2.0;
} // namespace

/// Searches for the strips along s.
class ClippedSquare::Search
{
public:
  explicit Search(std::vector<MonotoneRim> rims)
    : Rims(std::move(rims))
  {
  }

  bool Run(ClippedSquare& found)
  {
    std::vector<RimEnds> ends;
    for (const MonotoneRim& rim : Rims)
    {
      ends.push_back(rim.Ends());
    }
    Visit(-1.0, 1.0, ends);
    if (TooMany)
    {
      return false;
    }
    // Joins neighbours of the same kind.
    std::vector<Stretch> runs;
    for (const Stretch& stretch : Stretches)
    {
      if (!runs.empty() && runs.back().to == stretch.from && runs.back().kinds == stretch.kinds)
      {
        runs.back().to = stretch.to;
        continue;
      }
      runs.push_back(stretch);
    }
    found.Whole = false;
    found.Unknown = Unknown;
    return std::ranges::all_of(runs, [&](const Stretch& run) { return AddStrip(run, found); });
  }

private:
  struct Stretch
  {
    double from;
    double to;
    std::vector<RimKind> kinds; ///< by rim
  };

  void Visit(double from, double to, const std::vector<RimEnds>& ends)
  {
    TooMany = ++Looked > kMaxStretches;
    if (TooMany)
    {
      return;
    }
    std::vector<RimKind> kinds;
    bool decided = true;
    double unknown = 0.0;
    for (std::size_t k = 0; k < Rims.size(); ++k)
    {
      double strip = 0.0;
      kinds.push_back(Rims[k].KindOf(ends[k], strip));
      unknown += strip * (to - from);
      if (kinds.back() == RimKind::NothingIn)
      {
        Unknown = Up(Unknown + strip * (to - from));
        return;
      }
      decided = decided && kinds.back() != RimKind::Undecided;
    }
    if (decided)
    {
      Unknown = Up(Unknown + unknown);
      Stretches.push_back({ from, to, kinds });
      return;
    }
    if (to - from < kNarrowestStretch)
    {
      Unknown = Up(Unknown + 2.0 * (to - from));
      return;
    }
    const double middle = 0.5 * (from + to);
    std::vector<RimEnds> lower = ends;
    std::vector<RimEnds> upper;
    upper.reserve(ends.size());
    for (RimEnds& one : lower)
    {
      upper.push_back({ one.low.Subdivide(0), one.high.Subdivide(0) });
    }
    Visit(from, middle, lower);
    Visit(middle, to, upper);
  }

  bool AddStrip(const Stretch& run, ClippedSquare& found) const
  {
    // All ends are multiples of kNarrowestStretch, so that nothing is rounded.
    const double half = 0.5 * (run.to - run.from);
    ChebyshevModel s(0.5 * (run.from + run.to));
    s.c[ChebyshevModel::Index(1, 0)] = half;
    const Powers powers = PowersOf(s);
    std::optional<ChebyshevModel> low;
    std::optional<ChebyshevModel> high;
    for (std::size_t k = 0; k < Rims.size(); ++k)
    {
      if (run.kinds[k] != RimKind::Crosses)
      {
        continue;
      }
      std::optional<ChebyshevModel>& limit = Rims[k].IsUpper() ? high : low;
      if (limit)
      {
        return false;
      }
      limit = Rims[k].Between(run.from, run.to,
        [&powers](const ChebyshevModel& f, const ChebyshevModel& t)
        { return Composed(f, powers, PowersOf(t)); });
      if (!limit)
      {
        return false;
      }
      found.Unknown = Up(found.Unknown + 2.0 * limit->error * (run.to - run.from));
      limit = limit->Polynomial();
    }
    const ChebyshevModel from = low.value_or(ChebyshevModel(-1.0));
    const ChebyshevModel to = high.value_or(ChebyshevModel(1.0));
    const ChebyshevModel wide = to - from;
    if (low && high && !(wide.TightRange().lower > 0.0))
    {
      return false; // they may cross
    }
    const ChebyshevModel t = 0.5 * (to + from) + (0.5 * wide) * ChebyshevModel::Second();
    found.Strips.push_back({ powers, PowersOf(t), (0.5 * half) * wide });
    return true;
  }

  std::vector<MonotoneRim> Rims;
  std::vector<Stretch> Stretches;
  double Unknown = 0.0;
  int Looked = 0;
  bool TooMany = false;
};

std::optional<ClippedSquare> ClippedSquare::Of(std::span<const ChebyshevModel> functions)
{
  std::vector<ChebyshevModel> mixed;
  ClippedSquare found;
  for (const ChebyshevModel& f : functions)
  {
    const Interval range = f.TightRange();
    if (!range.IsFinite())
    {
      return std::nullopt;
    }
    if (range.lower > 0.0)
    {
      found.Whole = false;
      return found;
    }
    // Where the whole surface lies in the rim, up to rounding, it counts as inside.
    if (range.upper > 0.0 && range.Magnitude() > kZeroInErrors * f.error)
    {
      mixed.push_back(f);
    }
  }
  if (mixed.empty())
  {
    return found;
  }
  for (const bool swapped : { false, true })
  {
    std::vector<MonotoneRim> rims;
    for (const ChebyshevModel& f : mixed)
    {
      if (auto rim = MonotoneRim::Of(swapped ? f.Transposed() : f))
      {
        rims.push_back(*rim);
      }
    }
    ClippedSquare clipped;
    clipped.Swapped = swapped;
    if (rims.size() == mixed.size() && Search(std::move(rims)).Run(clipped))
    {
      return clipped;
    }
  }
  return std::nullopt;
}

double ClippedSquare::Part() const
{
  double part = Whole ? 1.0 : 0.0;
  for (const Strip& strip : Strips)
  {
    part += strip.area.Integral().Middle() / 4.0;
  }
  return std::clamp(part, 0.0, 1.0);
}

Interval ClippedSquare::Integral(const ChebyshevModel& density) const
{
  if (Whole)
  {
    return density.Integral();
  }
  if (!std::isfinite(density.error))
  {
    return Interval::Everything();
  }
  const ChebyshevModel f = Swapped ? density.Transposed() : density;
  Interval sum = 0.0;
  for (const Strip& strip : Strips)
  {
    sum += (Composed(f, strip.s, strip.t) * strip.area).Integral();
  }
  // Chebyshev polynomials are below 1.1 as far outside the square as limits may lie.
  const double missed = Up(Unknown * (1.1 * density.Norm() + density.error));
  return sum + Interval(-missed, missed);
}

ClippedSquare::Powers ClippedSquare::PowersOf(const ChebyshevModel& argument)
{
  Powers powers;
  powers[0] = ChebyshevModel(1.0);
  powers[1] = argument;
  const ChebyshevModel twice = 2.0 * argument;
  for (std::size_t n = 2; n < powers.size(); ++n)
  {
    powers[n] = twice * powers[n - 1] - powers[n - 2];
  }
  return powers;
}

ChebyshevModel ClippedSquare::Composed(const ChebyshevModel& f, const Powers& s, const Powers& t)
{
  constexpr int n = ChebyshevModel::kDegree;
  ChebyshevModel sum;
  for (int j = 0; j <= n; ++j)
  {
    ChebyshevModel row;
    bool any = false;
    for (int i = 0; i + j <= n; ++i)
    {
      const double value = f.c[ChebyshevModel::Index(i, j)];
      if (value != 0.0)
      {
        row = row + value * s[static_cast<std::size_t>(i)];
        any = true;
      }
    }
    if (any)
    {
      sum = sum + (j == 0 ? row : row * t[static_cast<std::size_t>(j)]);
    }
  }
  sum.Widen(f.error);
  return sum;
}
} // namespace pixelexact
