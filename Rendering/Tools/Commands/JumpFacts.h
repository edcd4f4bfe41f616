// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"

#include "Core/Math/Rounding.h"
#include "Core/Math/Vec.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// Jumps of fields across the faces between elements, as `info --jumps` prints them.
namespace pixelexact
{
struct LoadedModel;

struct WorstFace
{
  double largest = 0.0;                   ///< |[u]| at the samples, numeric
  double bound = kInfinity;               ///< proven; infinite: none
  std::array<std::int64_t, 2> elements{}; ///< by their cells' numbers in the file
  Vec3 position{ 0.0 };
};

struct JumpsOfField
{
  std::string name;
  std::vector<WorstFace> worst; ///< the ten largest, largest first
  double largest = 0.0;         ///< of all faces
  double bound = 0.0;           ///< of all faces; infinite where one has none
  double l2 = 0.0;              ///< the root of the integral of |[u]|^2 over all faces
  double area = 0.0;            ///< of these; of a plane mesh the length
  double size = 0.0;            ///< the largest magnitude of a sampled value
  std::int64_t faces = 0;
  std::int64_t proven = 0; ///< faces with a bound
  std::int64_t zero = 0;   ///< faces whose largest jump is zero within rounding
  std::int64_t notFinite = 0;
  std::int64_t notFound = 0;
};

struct JumpFacts
{
  std::vector<JumpsOfField> fields;
  bool isPlane = false;
  double seconds = 0.0;
};

/// Compares fields or expressions across the faces between elements. Parallel, with progress on
/// stderr. Throws Error for a name that is none, and as FindFaceJumps.
JumpFacts FindJumpFacts(const LoadedModel& input, const std::vector<std::string>& names);

void AddTo(Table& table, const JumpFacts& facts);
/// Adds the member "jumps".
void AddTo(nlohmann::ordered_json& summary, const JumpFacts& facts);
} // namespace pixelexact
