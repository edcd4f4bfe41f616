// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/VertexHierarchy.h"

#include "Formats/MFEM/Text/MeshFormat.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
constexpr int kMostGenerations = 64;
} // namespace

void VertexHierarchy::ReadParents(TextScanner& scanner, bool scaled)
{
  const int count = scanner.Count("the number of vertices with parents", 4);
  for (int i = 0; i < count; ++i)
  {
    const int node = scanner.Integer("a vertex", 0, kMostNodes);
    Parents parents;
    parents.first = scanner.Integer("a parent", 0, kMostNodes);
    parents.second = scanner.Integer("a parent", 0, kMostNodes);
    if (scaled)
    {
      parents.share = scanner.Number("a vertex' place between its parents");
    }
    ParentsOf[node] = parents;
  }
}

void VertexHierarchy::ReadCoordinates(TextScanner& scanner, int dimension)
{
  const int count = scanner.Count("the number of vertices with coordinates", 2);
  if (count > 0)
  {
    const int space = ReadSpaceDimension(scanner, dimension);
    scanner.Positions(count, space, Coordinates);
  }
}

std::array<double, 3> VertexHierarchy::Position(TextScanner& scanner, int node, int generation)
{
  if (const auto known = Known.find(node); known != Known.end())
  {
    return known->second;
  }
  if (generation > kMostGenerations)
  {
    scanner.Fail("vertex " + std::to_string(node) + " has more than " +
      std::to_string(kMostGenerations) + " generations of parents; the file is damaged.");
  }
  std::array<double, 3> x{};
  const auto parents = ParentsOf.find(node);
  if (parents == ParentsOf.end())
  {
    if (3 * static_cast<std::size_t>(node) + 2 >= Coordinates.size())
    {
      scanner.Fail("vertex " + std::to_string(node) + " has neither coordinates nor parents.");
    }
    std::copy_n(&Coordinates[3 * static_cast<std::size_t>(node)], 3, x.begin());
  }
  else
  {
    const auto a = Position(scanner, parents->second.first, generation + 1);
    const auto b = Position(scanner, parents->second.second, generation + 1);
    const double share = parents->second.share;
    std::ranges::transform(
      a, b, x.begin(), [share](double p, double q) { return (1.0 - share) * p + share * q; });
  }
  Known.emplace(node, x);
  return x;
}
} // namespace pixelexact::mfem
