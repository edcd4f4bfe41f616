// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/SurfaceStatistics.h"

#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Core/Expression/Expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace pixelexact
{
namespace
{
/// Tolerances of integrals of functions with kinks, and of parts below a value, where none is
/// given.
constexpr double kKinkTolerance = 1e-4;
constexpr double kPartTolerance = 1e-6;
/// The width of a quantile's interval, relative to the range of values, and its integrals.
constexpr double kQuantileWidth = 1e-3;
constexpr int kQuantileSteps = 12;
constexpr std::array kQuantiles{ 0.05, 0.25, 0.5, 0.75, 0.95 };

std::string PercentText(double part)
{
  std::ostringstream text;
  text << "Quantile " << part;
  return text.str();
}

/// A name or an expression as a part of another expression.
std::string AsOperand(const HighOrderModel& model, const std::string& name)
{
  const bool isField =
    std::ranges::find(model.Fields(), name, &Field::name) != model.Fields().end();
  return isField ? "\"" + name + "\"" : "(" + name + ")";
}

class Statistics
{
public:
  Statistics(const HighOrderModel& model, const std::string& name, const SurfaceDomain& domain,
    const SurfaceIntegral& integral, const StatisticsRequest& request)
    : Model(model)
    , field_(model.GetField(name))
    , Operand(AsOperand(model, name))
    , Domain(domain)
    , Given(integral)
    , Request(request)
    , Area(integral.sums[0])
  {
    Area.lower = std::max(Area.lower, 0.0);
  }

  SurfaceStatistics Find()
  {
    const bool isScalar = field_.values.components == 1;
    if (!isScalar && (Request.classes > 0 || !Request.with.empty()))
    {
      throw Unsupported("statistics are those of a scalar, and '" + field_.name + "' has " +
        std::to_string(field_.values.components) +
        " components; name a component, as v.x, or the magnitude, as mag(v).");
    }
    if (Request.extremes || Request.norms || Request.classes > 0)
    {
      AddExtremes(isScalar);
    }
    if (Request.norms)
    {
      AddNorms(isScalar);
    }
    if (Request.classes > 0)
    {
      AddMoments();
      AddHistogram();
      for (const double part : kQuantiles)
      {
        Found.rows.push_back({ PercentText(part), Quantile(part) });
      }
    }
    if (!Request.with.empty())
    {
      AddCorrelation();
    }
    if (Numeric)
    {
      Found.notes.emplace_back("the field has jumps or second derivatives: minimum, maximum, norms "
                               "and statistics are numeric, their bounds are estimates");
    }
    return Found;
  }

private:
  /// The integral of a scalar expression; `tolerance` where none is given.
  Interval Integral(const std::string& text, double tolerance)
  {
    IntegralEffort effort = Request.effort;
    effort.tolerance = Request.isToleranceGiven ? effort.tolerance : tolerance;
    const SurfaceIntegral found = Domain.integrate(&Model.GetField(text), effort, std::nullopt);
    Numeric = Numeric || found.isNumeric;
    return found.sums[1];
  }

  /// The area, and the integral of the scalar, where it is at most `value`.
  SurfaceIntegral Below(double value)
  {
    IntegralEffort effort = Request.effort;
    effort.tolerance = Request.isToleranceGiven ? effort.tolerance : kPartTolerance;
    const bool isPlain = field_.mapping == Mapping::Identity;
    SurfaceIntegral found =
      Domain.integrate(isPlain ? &field_ : &Model.GetField("1*" + Operand), effort, value);
    Numeric = Numeric || found.isNumeric;
    return found;
  }

  void AddExtremes(bool isScalar)
  {
    Found.extremes = Domain.extremes(field_, isScalar ? 0 : FieldFunction::kNorm);
    const Extremes& extremes = Found.extremes->extremes;
    Numeric = Numeric || Found.extremes->isNumeric;
    HasExtremes = extremes.minimum.element >= 0 && extremes.maximum.element >= 0;
    if (!HasExtremes)
    {
      Found.notes.emplace_back("no value on the surface is known: there is no minimum");
      return;
    }
    if (Request.extremes)
    {
      Found.rows.push_back({ "Minimum", { extremes.minimum.bound, extremes.minimum.attained } });
      Found.rows.push_back({ "Maximum", { extremes.maximum.attained, extremes.maximum.bound } });
    }
    if (!extremes.met)
    {
      Found.notes.emplace_back(
        "the gap of minimum or maximum is larger than 1e-6 of the range: the "
        "work budget is exhausted");
    }
  }

  void AddNorms(bool isScalar)
  {
    const Extremes& extremes = Found.extremes->extremes;
    Interval first;
    // Without a change of sign |f| has no kink.
    if (isScalar && HasExtremes && extremes.minimum.bound >= 0.0)
    {
      first = Given.sums[1];
    }
    else if (isScalar && HasExtremes && extremes.maximum.bound <= 0.0)
    {
      first = -Given.sums[1];
    }
    else if (isScalar)
    {
      // |f| = f - 2 f where f <= 0.
      first = Given.sums[1] - Interval(2.0) * Below(0.0).sums[1];
    }
    else
    {
      first = Integral("mag(" + Operand + ")", kKinkTolerance);
    }
    const std::string square =
      isScalar ? Operand + "*" + Operand : "mag(" + Operand + ")*mag(" + Operand + ")";
    const std::string ofVector =
      field_.values.components == 3 ? "dot(" + Operand + "," + Operand + ")" : square;
    const Interval second = Integral(isScalar ? square : ofVector, Request.effort.tolerance);
    Found.rows.push_back({ "L1", { std::max(first.lower, 0.0), first.upper } });
    Found.rows.push_back({ "L2", Sqrt({ std::max(second.lower, 0.0), second.upper }) });
    if (HasExtremes)
    {
      Found.rows.push_back({ "Linf",
        isScalar
          ? Interval(std::max({ extremes.maximum.attained, -extremes.minimum.attained, 0.0 }),
              std::max(extremes.maximum.bound, -extremes.minimum.bound))
          : Interval(extremes.maximum.attained, extremes.maximum.bound) });
    }
  }

  /// The variance about the mean, from the moments about a number near it.
  struct Moments
  {
    Interval mean;
    double about = 0.0;
    Interval offset; ///< of the mean from the number
    Interval variance;
  };
  Moments MomentsOf(const std::string& operand, const Interval& integral)
  {
    Moments moments;
    moments.mean = integral / Area;
    moments.about = moments.mean.IsFinite() ? moments.mean.Middle() : 0.0;
    moments.offset = moments.mean - Interval(moments.about);
    const Interval square =
      Integral("(" + operand + "-" + NumberText(moments.about) + ")^2", Request.effort.tolerance);
    moments.variance = square / Area - Square(moments.offset);
    moments.variance.lower = std::max(moments.variance.lower, 0.0);
    return moments;
  }

  void AddMoments()
  {
    const Moments moments = MomentsOf(Operand, Given.sums[1]);
    Found.rows.push_back({ "Variance", moments.variance });
    Found.rows.push_back({ "Deviation", Sqrt(moments.variance) });
  }

  /// The part of the area on which the field is at most `value`.
  Interval PartBelow(double value)
  {
    const auto known = std::ranges::find(Steps, value, &Step::value);
    if (known != Steps.end())
    {
      return known->part;
    }
    Interval part = Below(value).sums[0] / Area;
    part = { std::clamp(part.lower, 0.0, 1.0), std::clamp(part.upper, 0.0, 1.0) };
    Steps.push_back({ value, part });
    return part;
  }

  void AddHistogram()
  {
    if (!HasExtremes)
    {
      return;
    }
    const double low = Found.extremes->extremes.minimum.bound;
    const double high = Found.extremes->extremes.maximum.bound;
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high))
    {
      Found.notes.emplace_back(low < high ? "the field is not bounded: there is no histogram"
                                          : "the field is constant: there is no histogram");
      return;
    }
    Interval before(0.0);
    for (int k = 1; k <= Request.classes; ++k)
    {
      const double from = Found.histogram.empty() ? low : Found.histogram.back().to;
      const bool isLast = k == Request.classes;
      const double to = isLast ? high : std::lerp(low, high, double(k) / Request.classes);
      const Interval now = isLast ? Interval(1.0) : PartBelow(to);
      const Interval part = now - before;
      Found.histogram.push_back(
        { from, to, { std::max(part.lower, 0.0), std::min(part.upper, 1.0) } });
      before = now;
    }
  }

  /// Holds the smallest value that the field does not exceed on `part` of the area.
  Interval Quantile(double part)
  {
    if (Found.histogram.empty())
    {
      return HasExtremes
        ? Interval(Found.extremes->extremes.minimum.bound, Found.extremes->extremes.maximum.bound)
        : Interval(
            -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    }
    double low = Found.histogram.front().from;
    double high = Found.histogram.back().to;
    const double width = kQuantileWidth * (high - low);
    double partAtLow = 0.0;
    double partAtHigh = 1.0;
    const auto narrow = [&](double value, const Interval& below)
    {
      if (below.upper < part && value > low)
      {
        low = value;
        partAtLow = below.Middle();
      }
      if (below.lower >= part && value < high)
      {
        high = value;
        partAtHigh = below.Middle();
      }
      return below.upper < part || below.lower >= part;
    };
    for (const Step& step : std::vector<Step>(Steps))
    {
      narrow(step.value, step.part);
    }
    for (int k = 0; k < kQuantileSteps && high - low > width; ++k)
    {
      const double share =
        partAtHigh > partAtLow ? (part - partAtLow) / (partAtHigh - partAtLow) : 0.5;
      const double value = std::lerp(low, high, k % 3 == 2 ? 0.5 : std::clamp(share, 0.05, 0.95));
      if (!narrow(value, PartBelow(value)))
      {
        // The quantile is near: its interval is closed about it.
        for (const double other : { value - 0.5 * width, value + 0.5 * width })
        {
          narrow(other, PartBelow(other));
        }
        break;
      }
    }
    return { low, high };
  }

  void AddCorrelation()
  {
    const Field& other = Model.GetField(Request.with);
    if (other.values.components != 1)
    {
      throw Unsupported("the correlation is that of two scalars, and '" + other.name + "' has " +
        std::to_string(other.values.components) + " components.");
    }
    const std::string second = AsOperand(Model, Request.with);
    const Moments own = MomentsOf(Operand, Given.sums[1]);
    const Moments its = MomentsOf(second, Integral(second, Request.effort.tolerance));
    const Interval product = Integral("(" + Operand + "-" + NumberText(own.about) + ")*(" + second +
        "-" + NumberText(its.about) + ")",
      Request.effort.tolerance);
    const Interval covariance = product / Area - own.offset * its.offset;
    const Interval scale = Sqrt(own.variance) * Sqrt(its.variance);
    Interval correlation(-1.0, 1.0);
    if (scale.lower > 0.0)
    {
      const Interval quotient = covariance / scale;
      correlation = { std::clamp(quotient.lower, -1.0, 1.0),
        std::clamp(quotient.upper, -1.0, 1.0) };
    }
    else
    {
      Found.notes.emplace_back("the correlation is not known: a variance may be zero");
    }
    Found.rows.push_back({ "Correlation", correlation });
  }

  struct Step
  {
    double value;
    Interval part;
  };

  const HighOrderModel& Model;
  const Field& field_;
  std::string Operand;
  const SurfaceDomain& Domain;
  const SurfaceIntegral& Given;
  const StatisticsRequest& Request;
  Interval Area;
  bool HasExtremes = false;
  bool Numeric = false;
  std::vector<Step> Steps;
  SurfaceStatistics Found;
};
} // namespace

SurfaceStatistics FindStatistics(const HighOrderModel& model, const std::string& name,
  const SurfaceDomain& domain, const SurfaceIntegral& integral, const StatisticsRequest& request)
{
  return Statistics(model, name, domain, integral, request).Find();
}
} // namespace pixelexact
