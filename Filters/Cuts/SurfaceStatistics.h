// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceStatistics_h
#define SurfaceStatistics_h

#include "Cuts/IntegralRows.h"
#include "PixelExactFiltersModule.h"

#include "Core/Integral/Integrate.h"
#include "Core/Integral/SurfaceExtremes.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pixelexact
{
class HighOrderModel;
struct SurfacePatch;

/// A surface in a model's mesh over which any field is integrated.
struct SurfaceDomain
{
  /// `below`: as in IntegralQuestion.
  std::function<SurfaceIntegral(
    const Field* field, const IntegralEffort& effort, std::optional<double> below)>
    integrate;
  /// `component`: as in FindExtremesOnCut.
  std::function<SurfaceExtremes(const Field& field, int component)> extremes;
};
/// The domains of the arguments of IntegratePatches, IntegrateCut (with the question's cut and
/// clips) and IntegrateBoundary. The views must outlive the domain.
PIXELEXACTFILTERS_EXPORT SurfaceDomain DomainOfPatches(std::span<const SurfacePatch> patches,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model);
PIXELEXACTFILTERS_EXPORT SurfaceDomain DomainOfCut(
  const IntegralCut& cut, std::span<const ImplicitPolynomial> clips, const HighOrderModel& model);
PIXELEXACTFILTERS_EXPORT SurfaceDomain DomainOfBoundary(std::span<const std::int32_t> attributes,
  std::span<const ImplicitPolynomial> clips, const HighOrderModel& model);

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
