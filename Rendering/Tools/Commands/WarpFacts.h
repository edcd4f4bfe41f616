// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"

#include "Core/Element/WarpLimit.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

// The scales at which a displacement inverts elements, as `info --warp-limit` prints them.
namespace pixelexact
{
struct InputRequest;
struct LoadedModel;

struct WarpFacts
{
  std::string field;
  WarpLimit limit;                   ///< of the magnitudes of scales
  double sign = 1.0;                 ///< of the scales
  std::int64_t cell = -1;            ///< of limit.element, by its number in the file
  std::vector<std::int64_t> leftOut; ///< the first elements that were left out, in the same way
  double seconds = 0.0;
};

/// Computes the limits for a displacement of the model, for positive or negative scales. Parallel,
/// with progress on stderr. Throws as DisplacementOf.
WarpFacts FindWarpFacts(
  const LoadedModel& input, const InputRequest& request, const std::string& field, bool negative);

void AddTo(Table& table, const WarpFacts& facts);
/// The member "warp_limit".
void AddTo(nlohmann::ordered_json& summary, const WarpFacts& facts);
} // namespace pixelexact
