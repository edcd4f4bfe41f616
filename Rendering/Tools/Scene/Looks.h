// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Look/Painter.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pixelexact
{
class ColorOptions;
class ContourBounds;
class ContourOptions;
struct Shot;

/// What the command line says of how a shot is shown. `contours`: null, or none given: none are.
[[nodiscard]] ViewLook LookOf(
  const ColorOptions& colors, const ContourOptions* contours, const Shot& shot);

/// How the layers of a shot are shown, in numbers: their colour maps and ranges, and the painter.
class Looks
{
public:
  /// Of a frame that has the buffers of NeedsOf(LookOf(...)). `bounds`: as of Painter. The options
  /// and the shot must outlive it. Throws Error as Resolve and Painter.
  Looks(const ColorOptions& colors, const ContourOptions* contours, const Shot& shot,
    const Frame& frame, std::shared_ptr<ContourBounds> bounds = nullptr);
  Looks(const Looks&) = delete;
  Looks& operator=(const Looks&) = delete;

  [[nodiscard]] const ViewLook& Look() const { return TheLook; }
  [[nodiscard]] const ResolvedLook& Resolved() const { return TheResolved; }
  [[nodiscard]] Painter& ThePainter() { return *Paints; }
  [[nodiscard]] const Painter& ThePainter() const { return *Paints; }

  /// By layer, of the colours of its surface; none: it is painted in one colour.
  [[nodiscard]] const std::vector<ValueRange>& Ranges() const { return TheRanges; }
  [[nodiscard]] const std::vector<ColorMap>& Maps() const { return TheMaps; }

private:
  ViewLook TheLook;
  ResolvedLook TheResolved;
  std::vector<ValueRange> TheRanges;
  std::vector<ColorMap> TheMaps;
  std::unique_ptr<Painter> Paints;
};
} // namespace pixelexact
