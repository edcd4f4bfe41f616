// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/ProbeTable.h"

#include <vector>

// Reports of `probe` over all of its points.
namespace pixelexact
{
class Stopwatch;
struct Field;
struct LoadedModel;

/// Prints JSON to stdout. `fields`: the evaluated fields, none where the input has none; `probed`:
/// at least one.
void PrintJson(const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns, const Stopwatch& stopwatch);
/// Prints the same as a table to stdout or, where stdout is a file, to stderr.
void PrintTable(const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns, const Stopwatch& stopwatch,
  bool onStderr);
} // namespace pixelexact
