// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Volume/TransferFunction.h"

#include "Core/Base/Error.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
bool IsShare(double v)
{
  return v >= 0.0 && v <= 1.0;
}

template <class Points>
void RequireAscending(const Points& points, const std::string& name, const char* what)
{
  bool isSound = !points.empty();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    isSound = isSound && std::isfinite(points[i].u) && (i == 0 || points[i].u >= points[i - 1].u);
  }
  if (!isSound)
  {
    throw Error(name + ": its " + what +
      " need one point or more, at finite values in ascending order; correct them");
  }
}

/// The limits from below and above at a place, of one list of points.
template <class Point, class Value>
std::array<Value, 2> LimitsAt(const std::vector<Point>& points, double u, Value Point::*member)
{
  const auto first = std::ranges::lower_bound(points, u, {}, &Point::u);
  const auto last = std::ranges::upper_bound(points, u, {}, &Point::u);
  if (first != last)
  {
    // Several points at one place are a jump.
    return { (*first).*member, (*std::prev(last)).*member };
  }
  if (first == points.begin() || first == points.end())
  {
    const Value end = (first == points.begin() ? points.front() : points.back()).*member;
    return { end, end };
  }
  const Point& below = *std::prev(first);
  const double share = (u - below.u) / (first->u - below.u);
  Value between = below.*member;
  if constexpr (std::is_same_v<Value, double>)
  {
    between += share * ((*first).*member - between);
  }
  else
  {
    for (std::size_t c = 0; c < between.size(); ++c)
    {
      between[c] += share * (((*first).*member)[c] - between[c]);
    }
  }
  return { between, between };
}

double ShareOf(const TransferFunction::Part& part, double u)
{
  const double length = part.to - part.from;
  return std::isfinite(length) && length > 0.0 ? std::clamp((u - part.from) / length, 0.0, 1.0)
                                               : 0.0;
}
} // namespace

TransferFunction::TransferFunction(std::vector<ColorPoint> colors,
  std::vector<OpacityPoint> opacities, double unit, const char* name)
  : colors_(std::move(colors))
  , opacities_(std::move(opacities))
  , unit_(unit)
{
  RequireAscending(colors_, name, "colours");
  RequireAscending(opacities_, name, "opacities");
  const bool areShares =
    std::ranges::all_of(
      colors_, [](const ColorPoint& point) { return std::ranges::all_of(point.rgb, &IsShare); }) &&
    std::ranges::all_of(opacities_, &IsShare, &OpacityPoint::alpha);
  if (!areShares)
  {
    throw Error(std::string(name) + ": a colour or an opacity is not between 0 and 1; correct it");
  }
  if (!(unit > 0.0) || !std::isfinite(unit))
  {
    throw Error(std::string(name) + ": the unit distance must be a positive number");
  }
  for (OpacityPoint& point : opacities_)
  {
    isLimited_ = isLimited_ || point.alpha > kMaxOpacity;
    point.alpha = std::min(point.alpha, kMaxOpacity);
  }
  MakeParts();
}

void TransferFunction::MakeParts()
{
  std::vector<double> places;
  places.reserve(colors_.size() + opacities_.size());
  std::ranges::transform(colors_, std::back_inserter(places), &ColorPoint::u);
  std::ranges::transform(opacities_, std::back_inserter(places), &OpacityPoint::u);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  Part part{};
  part.from = -kInfinity;
  parts_.reserve(places.size() + 1);
  for (const double u : places)
  {
    const auto alpha = LimitsAt(opacities_, u, &OpacityPoint::alpha);
    const auto rgb = LimitsAt(colors_, u, &ColorPoint::rgb);
    part.to = u;
    part.alpha[1] = alpha[0];
    part.rgb[1] = rgb[0];
    if (parts_.empty())
    {
      // Below the first point all is constant.
      part.alpha[0] = alpha[0];
      part.rgb[0] = rgb[0];
    }
    parts_.push_back(part);
    part = { u, u, { alpha[1], alpha[1] }, { rgb[1], rgb[1] } };
  }
  part.to = kInfinity;
  parts_.push_back(part);
  for (const Part& one : parts_)
  {
    const double length = one.to - one.from;
    largestTau_ = std::max(largestTau_, -std::log1p(-std::max(one.alpha[0], one.alpha[1])) / unit_);
    if (std::isfinite(length))
    {
      const double change =
        std::max(std::fabs(one.alpha[1] - one.alpha[0]), ChangeOf(one.rgb[1], one.rgb[0]));
      steepness_ = std::max(steepness_, change / length);
    }
  }
}

std::size_t TransferFunction::PartOf(double u) const
{
  // The first part that ends above u; NaN belongs to the last one.
  const auto found = std::ranges::upper_bound(parts_, u, {}, &Part::to);
  return found == parts_.end() ? parts_.size() - 1
                               : static_cast<std::size_t>(found - parts_.begin());
}

double TransferFunction::TauOf(std::size_t part, double u) const
{
  const Part& of = parts_[part];
  const double alpha = of.alpha[0] + ShareOf(of, u) * (of.alpha[1] - of.alpha[0]);
  return -std::log1p(-alpha) / unit_;
}

std::array<double, 3> TransferFunction::ColorOf(std::size_t part, double u) const
{
  const Part& of = parts_[part];
  const double share = ShareOf(of, u);
  std::array<double, 3> color{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    color[c] = of.rgb[0][c] + share * (of.rgb[1][c] - of.rgb[0][c]);
  }
  return color;
}

std::array<double, 3> TransferFunction::Bounds::ChordOfColor(double u) const
{
  std::array<double, 3> color{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    color[c] = colorAt[c] + colorChord[c] * (u - lower);
  }
  return color;
}

double TransferFunction::ChangeOf(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::max({ std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2]) });
}

TransferFunction::Bounds TransferFunction::BoundsOver(double lower, double upper, bool chords) const
{
  Bounds bounds;
  bounds.part = PartOf(lower);
  const std::size_t last = std::max(bounds.part, PartOf(upper));
  bounds.isSmooth = bounds.part == last;
  double curved = 0.0;
  for (std::size_t k = bounds.part; k <= last; ++k)
  {
    const Part& part = parts_[k];
    const double from = std::max(lower, part.from);
    const double to = std::min(upper, part.to);
    const double tau = std::max(TauOf(k, from), TauOf(k, to));
    bounds.tau = std::max(bounds.tau, tau);
    const double length = part.to - part.from;
    if (std::isfinite(length))
    {
      // tau' = alpha' / (1 - alpha) / unit, tau'' = (alpha' / (1 - alpha))^2 / unit.
      const double slope =
        std::fabs(part.alpha[1] - part.alpha[0]) / length * std::exp(tau * unit_);
      bounds.tauSlope = std::max(bounds.tauSlope, slope / unit_);
      bounds.tauBend = std::max(bounds.tauBend, slope * slope / unit_);
      bounds.colorSlope = std::max(bounds.colorSlope, ChangeOf(part.rgb[1], part.rgb[0]) / length);
      curved = std::max(curved, 0.125 * slope * slope / unit_ * (to - from) * (to - from));
    }
  }
  if (!bounds.isSmooth || chords)
  {
    SetChords(lower, upper, last, bounds);
    bounds.tauOff += curved;
  }
  return bounds;
}

void TransferFunction::SetChords(double lower, double upper, std::size_t last, Bounds& bounds) const
{
  bounds.lower = lower;
  bounds.tauAt = TauOf(bounds.part, lower);
  bounds.colorAt = ColorOf(bounds.part, lower);
  const double length = upper - lower;
  const std::array<double, 3> end = ColorOf(last, upper);
  if (length > 0.0)
  {
    bounds.tauChord = (TauOf(last, upper) - bounds.tauAt) / length;
    for (std::size_t c = 0; c < 3; ++c)
    {
      bounds.colorChord[c] = (end[c] - bounds.colorAt[c]) / length;
    }
  }
  for (std::size_t k = bounds.part + 1; k <= last; ++k)
  {
    // The largest distance is at a place between two parts, on either side of a jump.
    const double u = parts_[k].from;
    const std::array<double, 3> color = bounds.ChordOfColor(u);
    for (const std::size_t side : { k - 1, k })
    {
      bounds.tauOff = std::max(bounds.tauOff, std::fabs(TauOf(side, u) - bounds.ChordOfTau(u)));
      bounds.colorOff = std::max(bounds.colorOff, ChangeOf(ColorOf(side, u), color));
    }
  }
  bounds.tauSlope = std::fabs(bounds.tauChord);
  bounds.colorSlope = ChangeOf(bounds.colorChord, {});
}
} // namespace pixelexact
