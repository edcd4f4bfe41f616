// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Basis.h"

#include "Core/Base/Error.h"
#include "Formats/CardinalFunctions.h"
#include "Formats/Gmsh/NodeOrder.h"

#include <algorithm>
#include <map>

namespace pixelexact::gmsh
{
namespace
{
/// Positions of the nodes in the element.
class NodePlaces
{
public:
  NodePlaces(Shape shape, int order)
  {
    const auto nodes = NodeOrder(shape, order);
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      Place[nodes[i]] = static_cast<int>(i);
    }
  }

  [[nodiscard]] int At(int i, int j, int k) const { return Place.at({ i, j, k }); }

private:
  std::map<Lattice, int> Place;
};

ChangeOfBasis Hexahedron(int n)
{
  const NodePlaces places(Shape::Hexahedron, n);
  std::vector<int> source;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; k <= n; ++k)
      {
        source.push_back(places.At(i, j, k));
      }
    }
  }
  return ChangeOfBasis::Hexahedron(
    UniformSpace(Shape::Hexahedron, n), Family::EquispacedLagrange, source);
}

ChangeOfBasis Tetrahedron(int n)
{
  const NodePlaces places(Shape::Tetrahedron, n);
  std::vector<int> source;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n - i; ++j)
    {
      for (int k = 0; k <= n - i - j; ++k)
      {
        source.push_back(places.At(i, j, k));
      }
    }
  }
  return ChangeOfBasis::Tetrahedron(
    UniformSpace(Shape::Tetrahedron, n), Family::EquispacedLagrange, source);
}

ChangeOfBasis Prism(int n)
{
  const NodePlaces places(Shape::Prism, n);
  std::vector<int> source;
  for (int i = 0; i <= n; ++i)
  {
    for (int k = 0; k <= n - i; ++k)
    {
      for (int j = 0; j <= n; ++j)
      {
        source.push_back(places.At(i, k, n - j)); // w runs against xi2
      }
    }
  }
  return ChangeOfBasis::Prism(UniformSpace(Shape::Prism, n), Family::EquispacedLagrange, source);
}

bool IsTriangle(const ElementType& type)
{
  return type.dimension == 2 && type.corners == 3;
}

/// Of the type's order; of plane elements 0 across.
Space SpaceOf(const ElementType& type)
{
  Space space = UniformSpace(type.shape, type.order);
  if (type.dimension == 2)
  {
    space.order[type.shape == Shape::Prism ? 1 : 2] = 0;
  }
  return space;
}

/// The first nodes of an element, as many as the type has; all shapes' lattices fill xi's cube in
/// the same way.
std::vector<LongVec3> NodesInXi(const ElementType& type)
{
  const bool isPlane = type.dimension == 2;
  std::vector<LongVec3> nodes;
  for (const Lattice& at :
    isPlane ? PlaneOrder(IsTriangle(type), type.order) : NodeOrder(type.shape, type.order))
  {
    const auto x = [&](int d) { return 2.0L * at[d] / type.order - 1; };
    if (isPlane)
    {
      nodes.push_back(IsTriangle(type) ? LongVec3{ x(0), 0, x(1) } : LongVec3{ x(0), x(1), 0 });
      continue;
    }
    nodes.push_back(
      type.shape == Shape::Prism ? LongVec3{ x(0), -x(2), x(1) } : LongVec3{ x(0), x(1), x(2) });
  }
  nodes.resize(static_cast<std::size_t>(type.nodes));
  return nodes;
}

/// A complete triangle or quadrilateral.
ChangeOfBasis Plane(const ElementType& type)
{
  const int n = type.order;
  std::map<Lattice, int> place;
  for (const Lattice& at : PlaneOrder(IsTriangle(type), n))
  {
    place.emplace(at, static_cast<int>(place.size()));
  }
  std::vector<int> source;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= (IsTriangle(type) ? n - i : n); ++j)
    {
      source.push_back(place.at({ i, j, 0 }));
    }
  }
  return IsTriangle(type)
    ? ChangeOfBasis::Prism(SpaceOf(type), Family::EquispacedLagrange, source)
    : ChangeOfBasis::Hexahedron(SpaceOf(type), Family::EquispacedLagrange, source);
}

/// Whether a mode of the complete space is one of the incomplete element's.
bool IsSerendipity(Shape shape, int p, int q, int r)
{
  switch (shape)
  {
    case Shape::Hexahedron: // linear in two directions
      return (p > 1 ? 1 : 0) + (q > 1 ? 1 : 0) + (r > 1 ? 1 : 0) <= 1;
    case Shape::Prism: // linear in the triangle, or along the line
      return p + r <= 1 || q <= 1;
    default:
      return p < 2 || q < 2;
  }
}

ElementBasis Serendipity(const ElementType& type)
{
  if (type.shape == Shape::Tetrahedron || IsTriangle(type) ||
    (type.shape != Shape::Hexahedron && type.order > 2))
  {
    throw Unsupported(Describe(type.number) + " have no nodes " +
      (type.dimension == 2 ? "inside" : "in their faces") +
      ", and no document defines their functions; make complete "
      "elements (Gmsh: Mesh.SecondOrderIncomplete = 0, setOrder).");
  }
  const Space space = SpaceOf(type);
  std::vector<int> kept;
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      if (IsSerendipity(type.shape, p, q, r))
      {
        kept.push_back(mode);
      }
    });
  const auto modes = [space, kept](const LongVec3& xi, long double* values)
  {
    std::vector<long double> all(static_cast<std::size_t>(space.Modes()));
    EvaluateModes(space, xi, all.data());
    std::ranges::transform(kept, values, [&all](int mode) { return all[mode]; });
  };
  const int count = type.nodes;
  std::vector<long double> atNodes(std::size_t(count) * count);
  const auto nodes = NodesInXi(type);
  for (int k = 0; k < count; ++k)
  {
    modes(nodes[k], &atNodes[std::size_t(k) * count]);
  }
  return OnePart(ChangeOfBasis::FromFunctions(
    space, count, Combined(modes, count, DualMatrix(count, atNodes), count)));
}

} // namespace

ElementBasis OnePart(ChangeOfBasis part)
{
  ElementBasis basis;
  basis.sources = part.SourceSize();
  basis.parts.push_back(std::move(part));
  return basis;
}

ElementBasis NodalBasis(const ElementType& type)
{
  if (!type.complete)
  {
    return Serendipity(type);
  }
  if (type.dimension == 2)
  {
    return OnePart(Plane(type));
  }
  switch (type.shape)
  {
    case Shape::Hexahedron:
      return OnePart(Hexahedron(type.order));
    case Shape::Tetrahedron:
      return OnePart(Tetrahedron(type.order));
    case Shape::Prism:
      return OnePart(Prism(type.order));
    default:
      break;
  }
  const Space space = UniformSpace(type.shape, type.order);
  return OnePart(ChangeOfBasis::FromFunctions(space, type.nodes, Cardinal(space, NodesInXi(type))));
}

ElementBasis ConstantBasis(Shape shape)
{
  return OnePart(ChangeOfBasis::FromFunctions(UniformSpace(shape, 0), 1,
    [](const LongVec3& /*xi*/, long double* values) { *values = 1.0L; }));
}
} // namespace pixelexact::gmsh
