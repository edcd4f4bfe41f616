// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <vector>

// Ranges of fields and coordinates that info reports without proof.
namespace pixelexact
{
class Table;
struct Field;
struct Mesh;

/// A range as AttainedRange returns it: its ends are attained, and values exceed it by at most a
/// thousandth of it. None: no value is finite.
using FoundRange = std::optional<std::array<double, 2>>;

struct FoundRanges
{
  std::vector<FoundRange> components;
  FoundRange magnitude; ///< of vectors
};

FoundRanges FindRanges(const Mesh& mesh, const Field& field);

/// The bounds of the curved elements of a mesh with at least one element: x, y, z, lower and upper
/// each. They are attained up to rounding, and the mesh exceeds them by at most a thousandth of its
/// extent.
std::array<double, 6> FindBounds(const Mesh& mesh);

/// Adds rows below the field's row.
void AddTo(Table& table, const FoundRanges& ranges);
/// Adds the members "ranges" and, for vectors, "magnitude_range".
void AddTo(nlohmann::ordered_json& field, const FoundRanges& ranges);
} // namespace pixelexact
