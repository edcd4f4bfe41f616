// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Painter.h"
#include "Trace/View.h"

#include <memory>
#include <vector>

namespace pixelexact
{
class ColorOptions;
class ContourBounds;
class ContourOptions;
struct Shot;

/// The view that the command line describes. `contours`: null, or none given: there are none.
[[nodiscard]] View ViewOf(
  const ColorOptions& colors, const ContourOptions* contours, const Shot& shot);

/// The resolved appearance of a shot's layers: colour maps and ranges, and the painter.
class ShotAppearance
{
public:
  /// `frame` must have the buffers of NeedsOf(ViewOf(...)). `bounds`: as in Painter. The options
  /// and the shot must outlive this object. Throws Error as Resolve and Painter.
  ShotAppearance(const ColorOptions& colors, const ContourOptions* contours, const Shot& shot,
    const Frame& frame, std::shared_ptr<ContourBounds> bounds = nullptr);
  ShotAppearance(const ShotAppearance&) = delete;
  ShotAppearance& operator=(const ShotAppearance&) = delete;

  [[nodiscard]] const View& GetView() const { return Of; }
  [[nodiscard]] const ResolvedAppearance& Resolved() const { return resolved_; }
  [[nodiscard]] Painter& GetPainter() { return *Paints; }
  [[nodiscard]] const Painter& GetPainter() const { return *Paints; }

  /// By layer, the range of the colours of its surface; none: it has one colour.
  [[nodiscard]] const std::vector<ValueRange>& Ranges() const { return ranges_; }
  [[nodiscard]] const std::vector<ColorMap>& Maps() const { return maps_; }

private:
  View Of;
  ResolvedAppearance resolved_;
  std::vector<ValueRange> ranges_;
  std::vector<ColorMap> maps_;
  std::unique_ptr<Painter> Paints;
};
} // namespace pixelexact
