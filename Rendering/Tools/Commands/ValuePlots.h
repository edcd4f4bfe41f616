// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/ImageSize.h"
#include "Commands/ProbeTable.h"
#include "Cuts/SurfaceStatistics.h"
#include "Drawing/Plot.h"

#include <span>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

// Plots of values along lines, over time and of histograms: --plot of probe and integrate.
namespace pixelexact
{
/// --plot and the options that go with it.
class PlotOptions
{
public:
  void AddTo(CLI::App& command);
  [[nodiscard]] bool IsAsked() const { return !File.empty(); }
  /// Throws UsageError for a suffix that is no picture's, a size without --plot, and as
  /// CheckOutput.
  void Check(const std::vector<std::string>& read) const;
  [[nodiscard]] const std::string& Name() const { return File; }
  /// Writes the plot. Throws Error where that fails.
  void Write(Plot plot) const;

private:
  std::string File;
  ImageSize Size{ 1100, 720, {} };
  std::string Title;
};

/// Values of fields along a line, a series for each component and time step; or, of points that are
/// on no line, over the time of the steps, a series for each point. Throws Error where points are
/// on no line and there is one step, and for more than kMaxPlotSeries series.
Plot PlotOfProbe(const ProbePoints& points, const std::vector<ProbedStep>& steps);

/// The largest number of series, with which colours and legend distinguish them.
inline constexpr std::size_t kMaxPlotSeries = 14;

/// The parts of the area by class, in per cent, with their proven ranges.
Plot PlotOfHistogram(const std::string& field, const std::vector<HistogramClass>& histogram);

/// The rows of a surface at a time.
struct TimedRows
{
  std::string surface;
  double time = 0.0;
  std::vector<IntegralRow> rows;
};
/// A quantity over time, a series for each surface and component. Throws Error where no row has it,
/// listing those that exist, and for more than kMaxPlotSeries series.
Plot PlotOfRows(
  const std::string& field, const std::string& quantity, std::span<const TimedRows> all);
} // namespace pixelexact
