// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <vector>

// Between which values fields and coordinates are, as info tells without proving it.
namespace pixelexact
{
class Table;
struct Field;
struct Mesh;

/// As AttainedRange: attained, and left by a thousandth at most; none: nothing is finite.
using FoundRange = std::optional<std::array<double, 2>>;

struct FoundRanges
{
  std::vector<FoundRange> components;
  FoundRange magnitude; ///< of vectors
};

FoundRanges FindRanges(const Mesh& mesh, const Field& field);

/// Of the curved elements of a mesh that has some: x, y, z, lower and upper each. They are attained
/// up to rounding, and left by a thousandth of the mesh's extent at most.
std::array<double, 6> FindBounds(const Mesh& mesh);

/// Below the field's row.
void AddTo(Table& table, const FoundRanges& ranges);
/// The members "ranges" and, of vectors, "magnitude_range".
void AddTo(nlohmann::ordered_json& field, const FoundRanges& ranges);
} // namespace pixelexact
