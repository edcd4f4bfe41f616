// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pixelexact
{
struct Shot;

/// The extent of the paper's evaluation.
enum class PaperExtent : std::uint8_t
{
  Quick, ///< a minute or two
  Whole  ///< the paper's ranges
};

/// A point of one of the paper's figures.
struct PaperRow
{
  std::string figure; ///< "8a", ..., "11"
  std::string series;
  double x = 0.0; ///< order, elements, pixels or samples, depending on the figure
  double seconds = 0.0;
  double bytes = -1.0; ///< less than 0: not measured
};

/// A linear picture of figures 9 and 11, compared with the exact one.
struct PaperErrors
{
  std::int64_t triangles = 0;
  double cutSeconds = 0.0;     ///< until the triangles exist
  double contourSeconds = 0.0; ///< of vtkContourFilter
  double bytes = 0.0;
  double largest = 0.0; ///< error of a pixel, relative to the range
  double mean = 0.0;
  std::int64_t contourPixels = 0; ///< of the exact picture
  std::int64_t missed = 0;
  std::int64_t displaced = 0;
  std::int64_t invented = 0;
};

struct PaperResults
{
  std::vector<PaperRow> rows;
  /// Results of figures 9 and 11, which need data: those of the exact picture, and of linear ones.
  double exactSeconds = 0.0;
  double exactContourSeconds = 0.0;
  std::vector<PaperErrors> errors;
};

/// Section 6 of the paper on this machine: figures 8 and 10 on generated meshes (MadeBlock.h),
/// curved with maps of order 3. `progress` receives the progress from 0 to 1.
void MeasurePaper(
  PaperExtent extent, const std::function<void(double)>& progress, PaperResults& results);

/// Figures 9 and 11 on a plane through data: the first layer of a shot. Throws Error where that is
/// not a plane, or has no field.
void MeasurePaperErrors(const Shot& shot, PaperExtent extent, PaperResults& results);
} // namespace pixelexact
