// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/ProbeTable.h"

#include <vector>

// What probe tells of all of its points.
namespace pixelexact
{
class Stopwatch;
struct Field;
struct LoadedModel;

/// On stdout. `fields`: those that were probed, none where the input has none; `probed`: at least
/// one.
void PrintJson(const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns, const Stopwatch& stopwatch);
/// The same on stdout or, where stdout is a file's, on stderr.
void PrintTable(const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns, const Stopwatch& stopwatch,
  bool onStderr);
} // namespace pixelexact
