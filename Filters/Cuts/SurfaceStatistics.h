// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceStatistics_h
#define SurfaceStatistics_h

#include "Cuts/IntegralRows.h"
#include "Cuts/SurfaceDomain.h"
#include "PixelExactFiltersModule.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The numbers that are found in addition to the integrals.
struct StatisticsRequest
{
  bool norms = false;
  bool extremes = false;
  int classes = 0;  ///< of the histogram; 0: no statistics
  std::string with; ///< a scalar to correlate with; empty: none
  IntegralEffort effort;
  bool isToleranceGiven = false; ///< else functions with kinks and steps have a larger one

  [[nodiscard]] bool IsEmpty() const { return !norms && !extremes && classes == 0 && with.empty(); }
};

/// One class of a histogram: from, included, to, excluded but for the last one's.
struct HistogramClass
{
  double from = 0.0;
  double to = 0.0;
  Interval part; ///< of the area; proven
};

struct SurfaceStatistics
{
  /// In this order, where requested: "Minimum" and "Maximum" (of vectors of the magnitude); "L1",
  /// "L2", "Linf"; "Variance", "Deviation", "Quantile 0.05", ...; "Correlation". They hold the
  /// numbers.
  std::vector<IntegralRow> rows;
  std::vector<HistogramClass> histogram;
  std::optional<SurfaceExtremes> extremes;
  std::vector<std::string> notes; ///< for each reason why a number is not proven or not sharp
};

/// Proven numbers of a field over a surface, from its extremes, from integrals of expressions
/// (mag(v), f^2), and from integrals over the part where f <= c. The histogram divides the range
/// between the proven bounds. A quantile's interval is narrowed to 1e-3 of that range, if its
/// integrals allow it.
/// `name`: the field's name, or an expression. Throws Unsupported for statistics of a field that is
/// no scalar, and as the integrals.
PIXELEXACTFILTERS_EXPORT SurfaceStatistics FindStatistics(const HighOrderModel& model,
  const std::string& name, const SurfaceDomain& domain, const SurfaceIntegral& integral,
  const StatisticsRequest& request);
} // namespace pixelexact
#endif
