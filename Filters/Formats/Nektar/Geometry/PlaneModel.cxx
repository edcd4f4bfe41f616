// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/PlaneModel.h"

#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/Nektar/Geometry/FaceMaps.h"
#include "Formats/Nektar/Geometry/Geometry.h"

#include <algorithm>
#include <array>
#include <map>

namespace pixelexact::nektar
{
namespace
{
using Weights = std::array<long double, 4>;

/// The faces of VTK's linear cell of the slab that correspond to an element's edges.
constexpr std::array<std::int8_t, 4> kTriangleSides{ 2, 3, 4, -1 };
constexpr std::array<std::int8_t, 4> kSquareSides{ 2, 1, 3, 0 };

/// Nodes of an element, by the weights of its vertices, and the functions that are one at one of
/// them.
struct NodalBasis
{
  std::vector<Weights> nodes;
  ElementBasis basis;
};

ElementBasis OnePart(ChangeOfBasis part)
{
  ElementBasis basis;
  basis.sources = part.SourceSize();
  basis.parts.push_back(std::move(part));
  return basis;
}

/// A basis at Gauss-Lobatto points, along xi2 fastest.
NodalBasis Square(int order)
{
  const auto points = GaussLobattoPoints(order + 1);
  NodalBasis nodal;
  std::vector<int> source;
  for (const long double s : points)
  {
    for (const long double t : points)
    {
      const long double a = (1 + s) / 2;
      const long double b = (1 + t) / 2;
      source.push_back(static_cast<int>(nodal.nodes.size()));
      nodal.nodes.push_back({ (1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b });
    }
  }
  const auto n = static_cast<std::uint8_t>(order);
  const LineFunctions line = Lagrange(points);
  const LineFunctions constant{ 1, [](long double /*z*/, long double* value) { *value = 1.0L; } };
  nodal.basis = OnePart(ChangeOfBasis::FromLines(
    { Shape::Hexahedron, Form::Collapsed, { n, n, 0 } }, { line, line, constant }, source));
  return nodal;
}

/// A basis at Gauss-Lobatto points that are contracted inwards; vertex 1 at xi1 = 1, vertex 2 at
/// xi3 = 1.
NodalBasis Triangle(int order)
{
  const auto line = GaussLobattoPoints(order + 1);
  const auto n = static_cast<std::uint8_t>(order);
  const Space space{ Shape::Prism, Form::Collapsed, { n, 0, n } };
  const auto modes = static_cast<std::size_t>(space.Modes());
  NodalBasis nodal;
  std::vector<long double> atNodes(modes * modes);
  std::vector<long double> identity(modes * modes, 0.0L);
  for (int j = 0; j <= order; ++j)
  {
    for (int i = 0; i + j <= order; ++i)
    {
      const long double a = (1 + line[i]) / 2;
      const long double b = (1 + line[j]) / 2;
      const long double c = (1 + line[order - i - j]) / 2;
      const long double sum = a + b + c;
      const std::size_t k = nodal.nodes.size();
      EvaluateModes(space, { 2 * a / sum - 1, 0, 2 * b / sum - 1 }, &atNodes[k * modes]);
      identity[k * (modes + 1)] = 1.0L;
      nodal.nodes.push_back({ c / sum, a / sum, b / sum, 0 });
    }
  }
  const auto count = static_cast<int>(modes);
  const BasisFactor toModes = SolveFactor(count, count, atNodes, identity);
  nodal.basis = OnePart(ChangeOfBasis::FromFunctions(space, count,
    [&](const LongVec3& xi, long double* values)
    {
      std::vector<long double> mode(modes);
      EvaluateModes(space, xi, mode.data());
      for (std::size_t k = 0; k < modes; ++k)
      {
        values[k] = 0.0L;
        for (std::size_t m = 0; m < modes; ++m)
        {
          values[k] += mode[m] * toModes.matrix[m * modes + k];
        }
      }
    }));
  return nodal;
}

const Face& FaceOf(const Geometry& source, const Solid& element)
{
  return source.faces.at(element.faces[0]);
}

void AddMap(const Geometry& source, const std::string& name, SolverMesh& mesh)
{
  const FaceMaps maps(source);
  std::map<std::pair<Shape, int>, NodalBasis> known;
  std::vector<const NodalBasis*> nodal;
  std::vector<const ElementBasis*> bases;
  for (const Solid& element : source.solids)
  {
    const int order = maps.OrderOf(FaceOf(source, element));
    auto at = known.find({ element.shape, order });
    if (at == known.end())
    {
      at = known
             .emplace(std::pair(element.shape, order),
               element.shape == Shape::Prism ? Triangle(order) : Square(order))
             .first;
    }
    nodal.push_back(&at->second);
    bases.push_back(&at->second.basis);
  }
  AssemblePlaneMap(
    bases, 3,
    [&](std::size_t e, std::span<double> values)
    {
      const auto& nodes = nodal[e]->nodes;
      const Face& face = FaceOf(source, source.solids[e]);
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const LongVec3 x = maps.At(face, nodes[i]);
        for (std::size_t c = 0; c < 3; ++c)
        {
          values[c * nodes.size() + i] = static_cast<double>(x[c]);
        }
      }
    },
    [&](std::size_t e) { return name + ": element " + std::to_string(source.solids[e].id); }, mesh);
}
} // namespace

SolverModel MakePlaneModel(const Geometry& geometry, const std::string& name)
{
  if (geometry.solids.empty())
  {
    throw InvalidData(name + ": there are no triangles and quadrilaterals.");
  }
  SolverModel model;
  AddMap(geometry, name, model.mesh);
  FaceOwners owners;
  for (std::size_t e = 0; e < geometry.solids.size(); ++e)
  {
    const Solid& element = geometry.solids[e];
    const Face& face = FaceOf(geometry, element);
    model.mesh.number.push_back(element.id);
    Corners& corners = model.mesh.corners.emplace_back();
    const auto& sides = face.corners == 3 ? kTriangleSides : kSquareSides;
    for (int k = 0; k < face.corners; ++k)
    {
      corners[k] = corners[face.corners + k] = face.vertices[k];
      owners.emplace(face.edges[k], BoundaryFace{ static_cast<std::int32_t>(e), sides[k], 0 });
    }
  }
  AddGroups(geometry, owners, name, model);
  return model;
}
} // namespace pixelexact::nektar
