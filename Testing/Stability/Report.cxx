// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/Report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace pixelexact::testing
{
void Raise(double& worst, double value)
{
  worst = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(worst, value);
}

namespace
{
void Merge(Verdicts& total, const Verdicts& part)
{
  total.right += part.right;
  total.wrong += part.wrong;
  total.unknown += part.unknown;
}

void Merge(Errors& worst, const Errors& other)
{
  Raise(worst.inUlps, other.inUlps);
  Raise(worst.inMagnitudeUlps, other.inMagnitudeUlps);
  Raise(worst.overBound, other.overBound);
}

void Merge(Row& worst, const Row& other)
{
  worst.order = std::max(worst.order, other.order);
  Raise(worst.at, other.at);
  Raise(worst.condition, other.condition);
  Merge(worst.inside, other.inside);
  Merge(worst.outside, other.outside);
  worst.careful += other.careful;
  worst.steps = std::max(worst.steps, other.steps);
  worst.boxes = std::max(worst.boxes, other.boxes);
  Raise(worst.xiError, other.xiError);
  Raise(worst.xiOverBound, other.xiOverBound);
  Raise(worst.backwardOverBound, other.backwardOverBound);
  Merge(worst.value, other.value);
  Merge(worst.gradient, other.gradient);
}

/// Two digits; a dash for what was not measured.
std::string Short(double value)
{
  if (value == 0.0)
  {
    return "-";
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", value);
  return text;
}
} // namespace

void Errors::Add(double error, double value, double magnitude, double bound)
{
  Raise(inUlps, InUlps(error, value));
  Raise(inMagnitudeUlps, InUlps(error, magnitude));
  Raise(overBound, error == 0.0 ? 0.0 : std::fabs(error) / bound);
}

double InUlps(double error, double value)
{
  const double size = std::max(std::fabs(value), std::numeric_limits<double>::min());
  return std::fabs(error) / std::ldexp(1.0, std::ilogb(size) - 52);
}

void WriteRows(const std::vector<Row>& rows, std::ostream& out)
{
  out << "sweep,shape,order,parameter,at,condition,inside_right,inside_wrong,inside_unknown,"
         "outside_right,outside_wrong,outside_unknown,careful,steps,boxes,xi_error,xi_over_bound,"
         "backward_over_bound,value_ulps,value_magnitude_ulps,value_over_bound,gradient_ulps,"
         "gradient_magnitude_ulps,gradient_over_bound,seconds\n";
  for (const Row& row : rows)
  {
    out << '"' << row.sweep << "\",\"" << row.shape << "\"," << row.order << ",\"" << row.parameter
        << "\"," << row.at << ',' << row.condition;
    for (const Verdicts& verdicts : { row.inside, row.outside })
    {
      out << ',' << verdicts.right << ',' << verdicts.wrong << ',' << verdicts.unknown;
    }
    out << ',' << row.careful << ',' << row.steps << ',' << row.boxes << ',' << row.xiError << ','
        << row.xiOverBound << ',' << row.backwardOverBound;
    for (const Errors& errors : { row.value, row.gradient })
    {
      out << ',' << errors.inUlps << ',' << errors.inMagnitudeUlps << ',' << errors.overBound;
    }
    out << ',' << row.seconds << '\n';
  }
}

void WriteScatter(const std::vector<ScatterPoint>& points, std::ostream& out)
{
  out << "sweep,shape,at,condition,error,bound\n";
  for (const auto& point : points)
  {
    out << '"' << point.sweep << "\",\"" << point.shape << "\"," << point.at << ','
        << point.condition << ',' << point.error << ',' << point.bound << '\n';
  }
}

void WriteSummary(const std::vector<Row>& rows, std::ostream& out)
{
  std::vector<Row> worst;
  for (const Row& row : rows)
  {
    const auto same = [&](const Row& other)
    { return other.sweep == row.sweep && other.shape == row.shape; };
    const auto entry = std::ranges::find_if(worst, same);
    if (entry == worst.end())
    {
      worst.push_back(row);
    }
    else
    {
      Merge(*entry, row);
    }
  }
  out << "| sweep | shape | condition to | points in | wrong | unknown | points out | wrong |"
         " unknown | careful | steps | boxes | xi, 2^-53 | of bound | value, ulp | ulp of sum | of "
         "bound |"
         " gradient, ulp of sum | of bound |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : worst)
  {
    out << "| " << row.sweep << " | " << row.shape << " | " << Short(row.condition);
    for (const Verdicts& verdicts : { row.inside, row.outside })
    {
      out << " | " << verdicts.right + verdicts.wrong + verdicts.unknown << " | " << verdicts.wrong
          << " | " << verdicts.unknown;
    }
    out << " | " << row.careful << " | " << row.steps << " | " << row.boxes << " | "
        << Short(row.xiError) << " | " << Short(row.xiOverBound) << " | " << Short(row.value.inUlps)
        << " | " << Short(row.value.inMagnitudeUlps) << " | " << Short(row.value.overBound) << " | "
        << Short(row.gradient.inMagnitudeUlps) << " | " << Short(row.gradient.overBound) << " |\n";
  }
}
} // namespace pixelexact::testing
