// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Picture/ContourDrawing.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>

// What reports tell of contours.
namespace pixelexact
{
class Table;

/// Values, of all layers.
[[nodiscard]] std::size_t CountOf(const FoundContours& contours);

[[nodiscard]] nlohmann::ordered_json ToJson(const FoundContours& contours);
void AddContours(Table& table, const FoundContours& contours);
} // namespace pixelexact
