// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/Antialiasing.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ElementEdges.h"
#include "Trace/Modules/ElementOutlines.h"
#include "Trace/Modules/Lighting.h"

#include <array>
#include <optional>
#include <vector>

namespace pixelexact
{
class ColorOptions;
struct Shot;

/// How the layers of a shot are shown: colour maps over their ranges, lights, anti-aliasing,
/// edges, outlines.
class Looks
{
public:
  /// Throws Error as RangeOfLayer.
  Looks(const ColorOptions& colors, const Shot& shot, const Frame& frame);
  Looks(const Looks&) = delete;
  Looks& operator=(const Looks&) = delete;

  /// Points to modules here. `edges`: whether element edges that were asked for are drawn.
  [[nodiscard]] Pipeline MakePipeline(bool edges = true);

  /// By layer; none: it is painted in one colour.
  [[nodiscard]] const std::vector<std::optional<std::array<double, 2>>>& Ranges() const
  {
    return TheRanges;
  }
  [[nodiscard]] const std::vector<ColorMap>& Maps() const { return TheMaps; }
  [[nodiscard]] std::int64_t Refined() const { return Smooth ? Smooth->Refined() : 0; }

private:
  std::vector<std::optional<std::array<double, 2>>> TheRanges;
  std::vector<ColorMap> TheMaps;
  std::optional<ColorMapping> Colors;
  std::optional<Lighting> Lights;
  std::optional<Antialiasing> Smooth;
  std::optional<ElementEdges> Edges;
  std::optional<ElementOutlines> Outlines;
};

/// The buffers of centres that Looks of a shot read.
[[nodiscard]] Buffer NeedsOfLooks(const Shot& shot);
} // namespace pixelexact
