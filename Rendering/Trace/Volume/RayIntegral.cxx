// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Volume/RayIntegral.h"

#include "Trace/Volume/InsideSearch.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// The part of the tolerance that the rule of integration may use.
constexpr double kRuleShare = kVolumeTolerance / 4.0;
constexpr double kStepUp = 1.0 + 1e-9;
/// Any step may have this error, so that jumps of the transfer function need few steps.
constexpr double kStepAllowance = 1e-7;
/// Covers the rounding of one step, in which all numbers are at most about 1.
constexpr double kStepRounding = 1e-14;
} // namespace

/// The contribution of a step.
struct RayIntegral::Step
{
  double depth = 0.0; ///< optical
  std::array<double, 3> first{};
  std::array<double, 3> last{}; ///< colours at its ends; between them linear
  double ruleError = 0.0;
  double valueError = 0.0; ///< by the error of u
  bool isShort = false;    ///< u varies by less than its error, so shorter steps gain nothing
};

void RayIntegral::Begin(double length)
{
  color_ = {};
  through_ = 1.0;
  error_ = 0.0;
  begun_ = nullptr;
  rate_ = length > 0.0 ? kRuleShare / length : 0.0;
  shortest_ = 1e-9 * length;
}

RayIntegral::Place RayIntegral::PlaceAt(const RaySpan& span, const double* series, double x) const
{
  Place place{ 0.0, {} };
  const auto points = static_cast<std::size_t>(span.points);
  if (!magnitude_)
  {
    place.v[0] = place.u = ChebyshevSum({ series, points }, x);
    return place;
  }
  double sum = 0.0;
  for (std::size_t c = 0; c < components_; ++c)
  {
    place.v[c] = ChebyshevSum({ series + c * points, points }, x);
    sum += place.v[c] * place.v[c];
  }
  place.u = std::sqrt(sum);
  return place;
}

RayIntegral::Step RayIntegral::StepTo(
  const RaySpan& span, const Place& a, const Place& m, const Place& b, double width) const
{
  // Bounds of |u'| and |u''| over the step.
  double slope = 0.0;
  double bend = 0.0;
  double error = span.error;
  for (std::size_t c = 0; c < components_; ++c)
  {
    const double one = std::fabs(b.v[c] - a.v[c]) / width + 0.5 * bends_[c] * width;
    // Squares of lengths beyond 1e-100 and 1e100 would not be representable.
    slope = std::hypot(slope, one);
    bend = std::hypot(bend, bends_[c]);
  }
  slope *= kStepUp;
  bend *= kStepUp;
  if (magnitude_)
  {
    error *= std::sqrt(static_cast<double>(components_));
    // |v|'' is at most |v''| + |v'|^2 / |v|.
    const double least = m.u - 0.5 * slope * width;
    bend = least > 0.0 ? bend + slope * slope / least : kInfinity;
  }
  const double byBend = 0.125 * bend * width * width;
  const double bySlope = 0.5 * slope * width;
  double lower = std::min(a.u, b.u) - byBend;
  double upper = std::max(a.u, b.u) + byBend;
  if (!(byBend < bySlope))
  {
    lower = m.u - bySlope;
    upper = m.u + bySlope;
  }
  const double off = std::isfinite(error) ? error : 0.0;
  const auto bounds = transfer_.BoundsOver(lower - off, upper + off, !std::isfinite(bend));

  Step step;
  step.isShort = off >= upper - lower;
  if (bounds.tau == 0.0)
  {
    return step;
  }
  const double largestDepth = std::min(1.0, bounds.tau * width);
  step.valueError = error > 0.0
    ? (bounds.tauSlope * width + bounds.colorSlope * largestDepth) * error * kStepUp
    : 0.0;
  if (bounds.isSmooth && std::isfinite(bend))
  {
    const std::size_t part = bounds.part;
    step.depth = width / 6.0 *
      (transfer_.TauOf(part, a.u) + 4.0 * transfer_.TauOf(part, m.u) + transfer_.TauOf(part, b.u));
    step.first = transfer_.ColorOf(part, a.u);
    step.last = transfer_.ColorOf(part, b.u);
    const double tauSlope = bounds.tauSlope * slope;
    const double tauBend = bounds.tauBend * slope * slope + bounds.tauSlope * bend;
    const double w2 = width * width;
    step.ruleError =
      (tauBend * w2 * width / 81.0 + 0.125 * tauSlope * w2 * bounds.colorSlope * slope * width +
        0.125 * bounds.colorSlope * bend * w2 * largestDepth) *
      kStepUp;
    return step;
  }
  // Chords take the place of tau and colour. Where u bends without a bound, its mean and its
  // distance from linear are bounded by its slope.
  const bool bends = std::isfinite(bend) && byBend < bySlope;
  const double mean = (a.u + 4.0 * m.u + b.u) / 6.0;
  const double meanOff = bends ? bend * width * width / 81.0 : 2.0 * bySlope;
  const double linearOff = bends ? byBend : 2.0 * bySlope;
  step.depth = width * std::max(0.0, bounds.ChordOfTau(mean));
  step.first = bounds.ChordOfColor(a.u);
  step.last = bounds.ChordOfColor(b.u);
  step.ruleError =
    (width * (bounds.tauOff + bounds.tauSlope * meanOff) +
      0.125 * bounds.tauSlope * slope * width * width * bounds.colorSlope * 2.0 * bySlope +
      largestDepth * (bounds.colorOff + bounds.colorSlope * linearOff)) *
    kStepUp;
  return step;
}

void RayIntegral::Take(const Step& step)
{
  const double passed = std::exp(-step.depth);
  const double absorbed = -std::expm1(-step.depth);
  // Colour first + (last - first) y over the step, y from 0 to 1: the mean of y where light is
  // absorbed, times what is absorbed, is (1 - e^-D) / D - e^-D.
  const double moment = step.depth > 1e-4
    ? absorbed / step.depth - passed
    : step.depth * (0.5 - step.depth / 3.0 + step.depth * step.depth / 8.0);
  for (std::size_t c = 0; c < 3; ++c)
  {
    color_[c] += through_ * (step.first[c] * absorbed + (step.last[c] - step.first[c]) * moment);
  }
  const double most = std::min(1.0, through_ + error_);
  error_ += (most * std::min(1.0, step.ruleError + step.valueError) + kStepRounding) * kStepUp;
  through_ *= passed;
}

void RayIntegral::BeginSpan(const RaySpan& span, const double* series)
{
  if (begun_ == series)
  {
    return;
  }
  begun_ = series;
  const double scale = 1.0 / span.half;
  for (std::size_t c = 0; c < components_; ++c)
  {
    // |T_k'| is at most k^2, |T_k''| at most k^2 (k^2 - 1) / 3.
    double slope = 0.0;
    double bend = 0.0;
    for (int k = 1; k < span.points; ++k)
    {
      const double square = static_cast<double>(k) * k;
      const double size =
        std::fabs(series[c * static_cast<std::size_t>(span.points) + static_cast<std::size_t>(k)]);
      slope += square * size;
      bend += square * (square - 1.0) / 3.0 * size;
    }
    slopes_[c] = slope * scale * kStepUp;
    bends_[c] = bend * scale * scale * kStepUp;
  }
}

bool RayIntegral::Add(const RaySpan& span, const double* series, double from, double to)
{
  BeginSpan(span, series);
  const double scale = 1.0 / span.half;
  const auto at = [&](double t)
  { return PlaceAt(span, series, std::clamp((t - span.middle) * scale, -1.0, 1.0)); };
  double t = from;
  double width = to - from;
  Place first = at(t);
  while (t < to)
  {
    width = std::min(width, to - t);
    const bool isLast = t + width >= to;
    const double end = isLast ? to : t + width;
    const Place middle = at(t + 0.5 * width);
    const Place last = at(end);
    const Step step = StepTo(span, first, middle, last, width);
    const double allowed = rate_ * width + kStepAllowance;
    if (through_ * step.ruleError > allowed && width > shortest_ && !step.isShort)
    {
      // The error falls with the third power of the width, at least with the second.
      const double share = std::sqrt(allowed / (through_ * step.ruleError));
      width *= std::clamp(0.9 * share, 0.1, 0.5);
      continue;
    }
    Take(step);
    if (IsDark())
    {
      error_ += through_;
      return false;
    }
    first = last;
    t = end;
    width *= through_ * step.ruleError < 0.3 * allowed ? 2.0 : 1.0;
  }
  return true;
}

void RayIntegral::AddUncertainEnd(
  const RaySpan& span, const double* series, double t, double length)
{
  if (!(length > 0.0))
  {
    return;
  }
  BeginSpan(span, series);
  const double x = std::clamp((t - span.middle) / span.half, -1.0, 1.0);
  const Place at = PlaceAt(span, series, x);
  double off = 0.0;
  for (std::size_t c = 0; c < components_; ++c)
  {
    const double one = slopes_[c] * length + (std::isfinite(span.error) ? span.error : 0.0);
    off = std::hypot(off, one);
  }
  off *= kStepUp;
  const double tau = transfer_.BoundsOver(at.u - off, at.u + off, false).tau;
  error_ += std::min(1.0, through_ + error_) * std::min(1.0, 2.0 * length * tau) * kStepUp;
}

void RayIntegral::AddLayer(const std::array<double, 3>& rgb, double alpha)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    color_[c] += through_ * alpha * rgb[c];
  }
  const bool wasDark = IsDark();
  through_ *= 1.0 - alpha;
  // Matter behind it is not integrated.
  error_ += kStepRounding + (!wasDark && IsDark() ? through_ : 0.0);
}
} // namespace pixelexact
