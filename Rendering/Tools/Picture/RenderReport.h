// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Provenance.h"
#include "Picture/ContourReport.h"
#include "Picture/FieldArrows.h"
#include "Picture/FieldDots.h"
#include "Picture/FieldTexture.h"
#include "Scene/LayerRanges.h"
#include "Scene/QualitySettings.h"

#include "Trace/Volume/Volume.h"

#include <array>
#include <optional>

// Reports of render on a frame.
namespace pixelexact
{
class DebugOptions;
class ShotAppearance;
class Stopwatch;
struct Shot;

/// Results on the values of a frame.
struct Found
{
  std::optional<std::array<double, 2>> values; ///< of exact pixels
  PixelsBeyond beyond;                         ///< pixels outside of the ranges of colour maps
  std::optional<FoundContours> contours;       ///< where requested
  QualityFacts quality;                        ///< what was given up for speed
  std::optional<VolumeCounters> volume;
  std::optional<FoundArrows> arrows;
  std::optional<FoundDots> dots;
  std::optional<FoundTexture> texture;
};

/// Prints JSON to stdout.
void PrintJson(const Shot& shot, const Frame& frame, const Found& found,
  const ShotAppearance& appearance, const DebugOptions& debug, const RepeatedCommand& command,
  const Stopwatch& stopwatch);
/// Prints a table to stdout, or to stderr where stdout is a file.
void PrintTable(const Shot& shot, const Frame& frame, const Found& found,
  const ShotAppearance& appearance, const DebugOptions& debug, const RepeatedCommand& command,
  const Stopwatch& stopwatch, bool onStderr);

/// Warns on stderr about parts that the picture does not show exactly.
void WarnOf(const Shot& shot, const Frame& frame, const Found& found);
} // namespace pixelexact
