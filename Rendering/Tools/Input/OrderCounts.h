// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>

// Counts of elements by polynomial orders, and their texts.
namespace pixelexact
{
/// Polynomial orders along the three directions; the third of plane elements is kPlane.
using Orders = std::array<int, 3>;
using OrderCounts = std::map<Orders, std::int64_t>;

inline constexpr int kPlane = -1;

/// Counts elements by orders. `isPlane`: the elements are a slab's, whose order across has no
/// meaning.
OrderCounts CountOrders(const Expansion& expansion, bool isPlane = false);

/// "3" or, for several, "3 (40 elements), 4 (2 elements)".
std::string Text(const OrderCounts& counts);
/// Counts of elements by the highest of their orders.
nlohmann::ordered_json ToJson(const OrderCounts& counts);
/// Counts of elements by "3 x 5 x 7".
nlohmann::ordered_json DirectionsToJson(const OrderCounts& counts);
} // namespace pixelexact
