// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"

#include "Core/Element/Validity.h"
#include "Core/Location/Extremes.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// Minima and maxima of fields over the mesh, as `info --extremes` prints them.
namespace pixelexact
{
struct LoadedModel;

struct ExtremesOfField
{
  std::string name;
  bool discontinuous = false; ///< across elements, as CompareAcrossElements finds it
  /// By component; of vectors the magnitude's follow.
  std::vector<Extremes> extremes;
};

struct ExtremeFacts
{
  std::vector<ExtremesOfField> fields;
  std::array<std::int64_t, 3> count{}; ///< elements by Validity
  double seconds = 0.0;
};

/// Finds the extremes of fields or expressions. Parallel, with progress on stderr. Throws Error for
/// a name that is none, and for expressions whose ranges cannot be proven.
ExtremeFacts FindExtremeFacts(const LoadedModel& input, const std::vector<std::string>& names);

void AddTo(Table& table, const LoadedModel& input, const ExtremeFacts& facts);
/// Adds the member "extremes".
void AddTo(nlohmann::ordered_json& summary, const LoadedModel& input, const ExtremeFacts& facts);
} // namespace pixelexact
