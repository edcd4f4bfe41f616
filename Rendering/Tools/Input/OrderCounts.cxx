// SPDX-License-Identifier: BSD-3-Clause
#include "Input/OrderCounts.h"

#include "Base/Report.h"

#include "Core/Base/Counted.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace pixelexact
{
namespace
{
Orders OrdersOf(const Space& space, bool isPlane)
{
  if (isPlane)
  {
    // A prism's triangle has the first and the third.
    return { space.order[0], space.order[space.shape == Shape::Prism ? 2 : 1], kPlane };
  }
  Orders orders{ space.order[0], space.order[1], space.order[2] };
  if (space.form == Form::Tensor)
  {
    // The third one only makes room for the factors of the pyramid's collapse.
    orders[2] = std::max(orders[0], orders[1]);
  }
  return orders;
}

/// "3", or where the directions differ "3 x 5 x 7", "3 x 5" of plane elements.
std::string Label(const Orders& orders)
{
  const auto [p, q, r] = orders;
  if (r == kPlane)
  {
    return p == q ? fmt::format("{}", p) : fmt::format("{} x {}", p, q);
  }
  return p == q && q == r ? fmt::format("{}", p) : fmt::format("{} x {} x {}", p, q, r);
}
} // namespace

OrderCounts CountOrders(const Expansion& expansion, bool isPlane)
{
  OrderCounts counts;
  for (int e = 0; e < expansion.Elements(); ++e)
  {
    ++counts[OrdersOf(expansion.SpaceOf(e), isPlane)];
  }
  return counts;
}

std::string Text(const OrderCounts& counts)
{
  std::vector<std::string> texts;
  for (const auto& [orders, count] : counts)
  {
    texts.push_back(counts.size() > 1
        ? fmt::format("{} ({})", Label(orders), Counted(count, "element"))
        : Label(orders));
  }
  return texts.empty() ? "none" : Listed(texts);
}

nlohmann::ordered_json ToJson(const OrderCounts& counts)
{
  std::map<int, std::int64_t> highest;
  for (const auto& [orders, count] : counts)
  {
    highest[std::ranges::max(orders)] += count;
  }
  auto object = nlohmann::ordered_json::object();
  for (const auto& [order, count] : highest)
  {
    object[std::to_string(order)] = count;
  }
  return object;
}

nlohmann::ordered_json DirectionsToJson(const OrderCounts& counts)
{
  auto object = nlohmann::ordered_json::object();
  for (const auto& [orders, count] : counts)
  {
    object[Label(orders)] = count;
  }
  return object;
}
} // namespace pixelexact
