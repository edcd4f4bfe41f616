// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Provenance.h"
#include "Picture/ContourReport.h"
#include "Scene/LayerRanges.h"
#include "Scene/QualitySettings.h"

#include <array>
#include <optional>

// What render tells of a frame.
namespace pixelexact
{
class DebugOptions;
class ShotAppearance;
class Stopwatch;
struct Shot;

/// What there is to tell of the values.
struct Found
{
  std::optional<std::array<double, 2>> values; ///< of exact pixels
  PixelsBeyond beyond;                         ///< ranges of colour maps
  std::optional<FoundContours> contours;       ///< where they were asked for
  QualityFacts quality;                        ///< what was given up
};

/// On stdout.
void PrintJson(const Shot& shot, const Frame& frame, const Found& found,
  const ShotAppearance& appearance, const DebugOptions& debug, const RepeatedCommand& command,
  const Stopwatch& stopwatch);
/// On stdout, or on stderr, where stdout is a file's.
void PrintTable(const Shot& shot, const Frame& frame, const Found& found,
  const ShotAppearance& appearance, const DebugOptions& debug, const RepeatedCommand& command,
  const Stopwatch& stopwatch, bool onStderr);

/// Says on stderr what the picture does not show as it is.
void WarnOf(const Shot& shot, const Frame& frame, const Found& found);
} // namespace pixelexact
