// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/PatchKnots.h"

#include "Formats/MFEM/Text/TextScanner.h"

#include <algorithm>
#include <numeric>

namespace pixelexact::mfem
{
namespace
{
/// The edges of a patch along a direction, from its lower end to its upper one, in MFEM's order.
std::vector<std::array<int, 2>> EdgesAlong(const Cell& patch, int dimension, int direction)
{
  std::vector<std::array<int, 2>> edges;
  for (int i = 0; i < (dimension == 3 ? 8 : 4); ++i)
  {
    // The second direction's edges begin at corners 1, 0, 5 and 4.
    const int corner = direction == 1 ? i ^ 1 : i;
    std::array<int, 3> ends = EndsOf(corner);
    if (ends.at(direction) == 0)
    {
      ends.at(direction) = 1;
      edges.push_back({ patch.vertices.at(corner), patch.vertices.at(CornerAt(ends)) });
    }
  }
  return edges;
}

/// Whether the knot vector of the edge from a to b runs against this sense.
bool IsReversed(const PatchTopology& topology, int a, int b)
{
  return topology.knots[static_cast<std::size_t>(topology.FindEdge(a, b))].isReversed == (a < b);
}
} // namespace

void MakeKnotVectors(PatchTopology& topology)
{
  const auto dimension = static_cast<std::size_t>(topology.dimension);
  // A set for each patch and direction; its root is the least of those that are one.
  std::vector<std::size_t> parent(topology.patches.size() * dimension);
  std::iota(parent.begin(), parent.end(), std::size_t{ 0 });
  const auto root = [&parent](std::size_t i)
  {
    while (parent[i] != i)
    {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  constexpr std::size_t kUnset = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(topology.edges.size(), kUnset);
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    for (std::size_t d = 0; d < dimension; ++d)
    {
      for (const auto& [a, b] :
        EdgesAlong(topology.patches[p], topology.dimension, static_cast<int>(d)))
      {
        auto& known = first[static_cast<std::size_t>(topology.FindEdge(a, b))];
        known = known == kUnset ? p * dimension + d : known;
        const auto [low, high] = std::minmax({ root(known), root(p * dimension + d) });
        parent[high] = low;
      }
    }
  }
  std::map<std::size_t, int> numbers;
  for (std::size_t i = 0; i < parent.size(); ++i)
  {
    numbers.try_emplace(root(i), static_cast<int>(numbers.size()));
  }
  for (const std::size_t line : first)
  {
    topology.knots.push_back({ numbers.at(root(line)), false });
  }
  topology.vectors = static_cast<int>(numbers.size());
}

void OrientKnotVectors(const TextScanner& scanner, PatchTopology& topology)
{
  using Along = std::pair<std::size_t, int>; // patch and direction
  std::vector<std::vector<Along>> users(topology.edges.size());
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    for (int d = 0; d < topology.dimension; ++d)
    {
      for (const auto& [a, b] : EdgesAlong(topology.patches[p], topology.dimension, d))
      {
        users[static_cast<std::size_t>(topology.FindEdge(a, b))].emplace_back(p, d);
      }
    }
  }
  std::vector<bool> isSet(topology.edges.size(), false);
  std::set<Along> done;
  for (std::size_t p = topology.patches.size(); p-- > 0;)
  {
    for (int d = topology.dimension; d-- > 0;)
    {
      std::vector<Along> next{ { p, d } };
      while (!next.empty())
      {
        const Along along = next.back();
        next.pop_back();
        if (!done.insert(along).second)
        {
          continue;
        }
        const auto edges =
          EdgesAlong(topology.patches[along.first], topology.dimension, along.second);
        const auto number = [&](const std::array<int, 2>& edge)
        { return static_cast<std::size_t>(topology.FindEdge(edge[0], edge[1])); };
        const auto known =
          std::ranges::find_if(edges, [&](const auto& edge) { return isSet[number(edge)]; });
        const auto& reference = known == edges.end() ? edges.front() : *known;
        const bool wanted = IsReversed(topology, reference[0], reference[1]);
        for (const auto& edge : edges)
        {
          const std::size_t e = number(edge);
          if (topology.knots[e].vector != topology.knots[number(reference)].vector)
          {
            scanner.Fail("opposite edges of patch " + std::to_string(along.first) +
              " have different knot vectors; the section 'edges' contradicts the elements.");
          }
          if (IsReversed(topology, edge[0], edge[1]) != wanted)
          {
            if (isSet[e])
            {
              scanner.Fail("the knot vectors of patch " + std::to_string(along.first) +
                " cannot run in one sense along opposite edges.");
            }
            topology.knots[e].isReversed = !topology.knots[e].isReversed;
          }
          isSet[e] = true;
          next.insert(next.end(), users[e].begin(), users[e].end());
        }
      }
    }
  }
  for (const Cell& patch : topology.patches)
  {
    auto& lines = topology.lines.emplace_back();
    for (int d = 0; d < topology.dimension; ++d)
    {
      const auto [a, b] = EdgesAlong(patch, topology.dimension, d).front();
      const auto edge = static_cast<std::size_t>(topology.FindEdge(a, b));
      lines.at(d) = { topology.knots[edge].vector, IsReversed(topology, a, b) };
    }
  }
}
} // namespace pixelexact::mfem
