// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/ProbeTable.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

// Reports of `probe` over all of its points.
namespace pixelexact
{
class Table;
struct Field;
struct LoadedModel;

/// The report of a time step as JSON. `fields`: the evaluated fields, none where the input has
/// none; `probed`: at least one.
nlohmann::ordered_json ProbeJson(const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns);
/// Adds the same as rows.
void AddTo(Table& table, const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns);
} // namespace pixelexact
