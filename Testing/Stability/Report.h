// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

// The study's measurements, and their output.
namespace pixelexact::testing
{
/// Largest errors of a set of points, and what they were allowed.
struct Errors
{
  double inUlps = 0.0;          ///< of the value
  double inMagnitudeUlps = 0.0; ///< ulps of sum |c| |mode|
  double overBound = 0.0;       ///< of the bound from rounding and conditioning; right: <= 1

  void Add(double error, double value, double magnitude, double bound);
};

/// Verdicts on points of which it is known whether they are in the element.
struct Verdicts
{
  std::int64_t right = 0;
  std::int64_t wrong = 0;
  std::int64_t unknown = 0;
};

struct Row
{
  std::string sweep;
  std::string shape;
  int order = 0;
  std::string parameter;
  double at = 0.0;
  double condition = 0.0; ///< largest of all points
  Verdicts inside;
  Verdicts outside;
  std::int64_t careful = 0; ///< pairs of point and element left to the careful path
  int steps = 0;            ///< the most that Newton's iteration took
  int boxes = 0;            ///< the most that the careful path looked at for one of them
  double xiError = 0.0;     ///< in units of 2^-53
  double xiOverBound = 0.0;
  double backwardOverBound = 0.0; ///< of Phi(xi) - x
  Errors value;
  Errors gradient;
  double seconds = 0.0;
};

/// One point, for the plots of error against condition.
struct ScatterPoint
{
  std::string sweep;
  std::string shape;
  double at = 0.0;
  double condition = 0.0;
  double error = 0.0; ///< in units of 2^-53, or in ulps
  double bound = 0.0; ///< the same
};

/// Makes `worst` the larger of the two; a NaN is infinitely bad.
void Raise(double& worst, double value);

/// |error| in units in the last place of `value`.
double InUlps(double error, double value);

void WriteRows(const std::vector<Row>& rows, std::ostream& out);
void WriteScatter(const std::vector<ScatterPoint>& points, std::ostream& out);
/// Writes one line per sweep and shape, with the worst of its rows, in Markdown.
void WriteSummary(const std::vector<Row>& rows, std::ostream& out);
} // namespace pixelexact::testing
