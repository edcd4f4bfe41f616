// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Picture/RenderReport.h"
#include "Trade/Convergence.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>

// Reports of compare on two solutions, or on a series.
namespace pixelexact
{
class Stopwatch;
struct Shot;

/// Facts that are reported with the numbers.
struct DifferenceFacts
{
  SeriesRow row;                 ///< the other solution
  std::string otherField;        ///< with its kind
  std::array<double, 2> range{}; ///< of the colour map
};

/// "12 both, 3 only first, ...".
std::string PixelsText(const DifferenceNumbers& numbers);

/// Warns on stderr about pixels that the numbers do not cover.
void WarnOf(const DifferenceNumbers& numbers, const std::string& name);

nlohmann::ordered_json ToJson(const DifferenceNumbers& numbers);

/// Prints to stdout, or to stderr where stdout is a file.
void PrintDifference(const Shot& shot, const DifferenceFacts& facts, const RepeatedCommand& command,
  const Stopwatch& stopwatch, bool onStderr);
void PrintSeries(const Shot& shot, const Convergence& convergence, const RepeatedCommand& command,
  const Stopwatch& stopwatch);
} // namespace pixelexact
