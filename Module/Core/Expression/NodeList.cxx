// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/NodeList.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace pixelexact
{
NodeList::NodeList(const Graph& graph, std::span<const int> wanted)
{
  std::map<int, int> placeOf;
  for (const int number : graph.NeededFor(wanted))
  {
    placeOf[number] = static_cast<int>(nodes.size());
    Graph::Node& node = nodes.emplace_back(graph.At(number));
    for (int& argument : node.arguments)
    {
      argument = argument < 0 ? -1 : placeOf.at(argument);
    }
    if (node.arguments[0] < 0)
    {
      leaves.push_back(node);
    }
  }
  std::ranges::transform(wanted, std::back_inserter(outputs),
    [&](int node) { return static_cast<std::size_t>(placeOf.at(node)); });
}
} // namespace pixelexact
