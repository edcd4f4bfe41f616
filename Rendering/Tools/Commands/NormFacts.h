// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"

#include "Core/Integral/FieldNorms.h"
#include "Core/Math/Interval.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Norms of fields over the mesh, as `info --norms` prints them.
namespace pixelexact
{
struct LoadedModel;

struct NormsOfField
{
  std::string name;
  FieldNorms norms;
  /// Proven: holds the largest |f|. None where its range is not proven.
  std::optional<Interval> largest;
  int mostOfSquare = 0; ///< elements that carry 90 % of the integral of |f|^2, the fewest
};

struct NormFacts
{
  std::vector<NormsOfField> fields;
  bool isPlane = false;
  double seconds = 0.0;
};

/// Finds the norms of fields or expressions. Parallel, with progress on stderr. Throws Error for a
/// name that is none, and as FindNorms.
NormFacts FindNormFacts(const LoadedModel& input, const std::vector<std::string>& names);

void AddTo(Table& table, const LoadedModel& input, const NormFacts& facts);
/// Adds the member "norms".
void AddTo(nlohmann::ordered_json& summary, const LoadedModel& input, const NormFacts& facts);

/// Writes a row for each field and element, by descending part of the integral of |f|^2. Throws
/// Error where the file cannot be written.
void WriteNorms(const std::string& file, const LoadedModel& input, const NormFacts& facts);
} // namespace pixelexact
