// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Fields/BoundaryBasis.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Fields/FieldBasis.h"
#include "Formats/Nektar/Geometry/ReferenceShapes.h"
#include "Formats/Nektar/Geometry/SolidTable.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::nektar
{
namespace
{
/// The modes are of the order of 1.
constexpr long double kVanishing = 1e-12L;

/// Dense matrices of all modes: higher orders take minutes.
constexpr int kHighestOrder = 10;

using Weights = std::array<long double, 4>;

/// Gauss-Lobatto points of a face, as weights of its vertices; on triangles drawn inwards so that
/// they agree with those of the edges.
std::vector<Weights> FaceNodes(int corners, int order)
{
  const auto line = GaussLobattoPoints(order + 1);
  std::vector<Weights> nodes;
  for (int j = 0; j <= order; ++j)
  {
    for (int i = 0; i <= (corners == 3 ? order - j : order); ++i)
    {
      const long double a = (1 + line[i]) / 2;
      const long double b = (1 + line[j]) / 2;
      if (corners == 4)
      {
        nodes.push_back({ (1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b });
        continue;
      }
      const long double c = (1 + line[order - i - j]) / 2;
      const long double sum = a + b + c;
      nodes.push_back({ c / sum, a / sum, b / sum, 0 });
    }
  }
  return nodes;
}

LongVec3 PlaceOf(const SolidTable& table, const BoundaryBasis::Node& node)
{
  LongVec3 xi{};
  const SolidFace& face = table.faces[node.face];
  for (int k = 0; k < face.corners; ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      xi[d] += node.weights[k] * table.vertices[face.vertices[k]][d];
    }
  }
  return xi;
}

/// The modes that do not vanish at some of the places, by their numbers in `modes`.
std::vector<int> SeenModes(
  Shape shape, const std::vector<Mode>& modes, std::span<const LongVec3> places)
{
  std::vector<int> seen;
  for (int m = 0; m < static_cast<int>(modes.size()); ++m)
  {
    if (std::ranges::any_of(places,
          [&](const LongVec3& xi)
          { return std::fabs(ModifiedMode(shape, modes[m], xi)) > kVanishing; }))
    {
      seen.push_back(m);
    }
  }
  return seen;
}

/// From values at a face's nodes to the coefficients of the modes that the face sees.
struct FaceFactor
{
  std::vector<int> modes;
  BasisFactor factor;
  int firstNode = 0;
};

FaceFactor MakeFaceFactor(
  Shape shape, const std::vector<Mode>& modes, std::span<const LongVec3> places, int firstNode)
{
  FaceFactor face{ SeenModes(shape, modes, places), {}, firstNode };
  const auto n = static_cast<int>(places.size());
  if (static_cast<int>(face.modes.size()) != n)
  {
    throw Error("a face of " + std::to_string(n) + " nodes sees " +
      std::to_string(face.modes.size()) + " modes.");
  }
  std::vector<long double> atNodes;
  std::vector<long double> identity(std::size_t(n) * n, 0.0L);
  for (int i = 0; i < n; ++i)
  {
    identity[std::size_t(i) * (n + 1)] = 1.0L;
    for (const int m : face.modes)
    {
      atNodes.push_back(ModifiedMode(shape, modes[m], places[i]));
    }
  }
  face.factor = SolveFactor(n, n, atNodes, identity);
  return face;
}
} // namespace

BoundaryBasis MakeBoundaryBasis(Shape shape, int order)
{
  if (order > kHighestOrder)
  {
    throw Unsupported("curved edges and faces of order " + std::to_string(order) +
      " are not read; up to order " + std::to_string(kHighestOrder) + " they are.");
  }
  const SolidTable& table = TableOf(shape);
  auto modes = ModesOf(shape, { order + 1, order + 1, order + 1 });
  std::erase_if(modes, [shape](const Mode& mode) { return IsInterior(shape, mode); });
  BoundaryBasis boundary;
  std::vector<FaceFactor> faces;
  std::vector<int> owner(modes.size(), 0); // the last face that sees the mode
  for (int f = 0; f < static_cast<int>(table.faces.size()); ++f)
  {
    const auto firstNode = static_cast<int>(boundary.nodes.size());
    std::vector<LongVec3> places;
    for (const Weights& weights : FaceNodes(table.faces[f].corners, order))
    {
      places.push_back(
        PlaceOf(table, boundary.nodes.emplace_back(BoundaryBasis::Node{ f, weights })));
    }
    faces.push_back(MakeFaceFactor(shape, modes, places, firstNode));
    for (const int m : faces.back().modes)
    {
      owner[m] = f;
    }
  }
  const auto sources = static_cast<int>(boundary.nodes.size());
  boundary.basis.sources = sources;
  boundary.basis.parts.push_back(ChangeInto(shape, { order, order, order }, sources,
    [&](const LongVec3& xi, long double* values)
    {
      std::fill_n(values, sources, 0.0L);
      for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      {
        const FaceFactor& face = faces[f];
        for (int k = 0; k < face.factor.rows; ++k)
        {
          if (owner[face.modes[k]] != f)
          {
            continue;
          }
          const long double value = ModifiedMode(shape, modes[face.modes[k]], xi);
          for (int i = 0; i < face.factor.columns; ++i)
          {
            values[face.firstNode + i] +=
              value * face.factor.matrix[std::size_t(k) * face.factor.columns + i];
          }
        }
      }
    }));
  return boundary;
}
} // namespace pixelexact::nektar
