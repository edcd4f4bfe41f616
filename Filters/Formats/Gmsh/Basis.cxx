// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Basis.h"

#include "Core/Base/Error.h"
#include "Formats/ElementBasis.h"
#include "Formats/Slab.h"

#include <algorithm>
#include <cstdlib>
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

/// The space of the type's order; plane elements have order 0 across.
Space SpaceOf(const ElementType& type)
{
  Space space = UniformSpace(type.shape, type.order);
  if (type.dimension == 2)
  {
    space.order[type.shape == Shape::Prism ? 1 : 2] = 0;
  }
  return space;
}

/// Reference positions of an element's nodes, as many as the type has. The lattices of all shapes
/// fill the cube of xi in the same way.
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

/// The change of basis of a complete triangle or quadrilateral.
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

/// The modes of hexahedra of order 9, the largest in Gmsh. Twice as many take ten times as long.
constexpr int kMaxDenseModes = 1000;

/// Gmsh's reference coordinates u, v, w of a point xi.
LongVec3 FromXi(int dimension, Shape shape, const LongVec3& xi)
{
  const auto half = [&xi](int d) { return (1 + xi[d]) / 2; };
  if (dimension == 2)
  {
    return shape == Shape::Prism ? LongVec3{ half(0), half(2), 0 } : LongVec3{ xi[0], xi[1], 0 };
  }
  switch (shape)
  {
    case Shape::Hexahedron:
      return xi;
    case Shape::Tetrahedron:
      return { half(0), half(1), half(2) };
    case Shape::Prism:
      return { half(0), half(2), -xi[1] };
    default:
      return { xi[0] + half(2), xi[1] + half(2), half(2) };
  }
}

long double Power(long double x, int exponent)
{
  long double power = 1.0L;
  for (int i = 0; i < std::abs(exponent); ++i)
  {
    power *= x;
  }
  return exponent < 0 ? 1 / power : power;
}

long double Monomial(Shape shape, const LongVec3& x, const int* e)
{
  const long double product = Power(x[0], e[0]) * Power(x[1], e[1]) * Power(x[2], e[2]);
  return shape == Shape::Pyramid ? product * Power(1 - x[2], std::max(e[0], e[1]) - e[0] - e[1])
                                 : product;
}

/// The smallest space that holds the monomials.
Space SpaceOf(int dimension, Shape shape, const Interpolation& interpolation)
{
  std::array<int, 3> order{ 0, 0, 0 };
  for (int j = 0; j < interpolation.functions; ++j)
  {
    const int* e = &interpolation.exponents[3 * static_cast<std::size_t>(j)];
    const int sum = e[0] + e[1] + e[2];
    const std::array<int, 3> needed = shape == Shape::Hexahedron
      ? std::array<int, 3>{ e[0], e[1], e[2] }
      : shape == Shape::Tetrahedron ? std::array<int, 3>{ sum, sum, sum }
      : shape == Shape::Prism       ? std::array<int, 3>{ e[0] + e[1], e[2], e[0] + e[1] }
                                    : std::array<int, 3>{ std::max(e[0], e[1]) + e[2],
                                        std::max(e[0], e[1]) + e[2], std::max(e[0], e[1]) + e[2] };
    std::ranges::transform(
      order, needed, order.begin(), [](int a, int b) { return std::max(a, b); });
  }
  if (dimension == 2 && shape == Shape::Prism)
  {
    order[1] = 0; // across
  }
  Space space = UniformSpace(shape, 0);
  for (int d = 0; d < 3; ++d)
  {
    space.order[d] = static_cast<std::uint8_t>(std::min(order[d], kMaxOrder + 1));
  }
  // Incomplete hexahedra of order 9 omit the most modes. A space that omits more would take time
  // out of proportion to the file.
  const int most = std::min(kMaxDenseModes, 100 + 10 * interpolation.functions);
  if (!space.IsValid() || space.Modes() > most)
  {
    throw Unsupported(std::to_string(interpolation.functions) + " functions on a " +
      (dimension == 2 ? PlaneName(shape) : Name(shape)) + " are of orders " +
      std::to_string(order[0]) + ", " + std::to_string(order[1]) + ", " + std::to_string(order[2]) +
      "; so many are read where the complete space of these orders has no "
      "more than " +
      std::to_string(most) + ".");
  }
  return space;
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

ElementBasis InterpolationBasis(int dimension, Shape shape, const Interpolation& interpolation)
{
  const Space space = SpaceOf(dimension, shape, interpolation);
  return OnePart(ChangeOfBasis::FromFunctions(space, interpolation.functions,
    [dimension, shape, interpolation](const LongVec3& xi, long double* values)
    {
      const auto n = static_cast<std::size_t>(interpolation.functions);
      const LongVec3 x = FromXi(dimension, shape, xi);
      std::vector<long double> monomial(n);
      for (std::size_t j = 0; j < n; ++j)
      {
        monomial[j] = Monomial(shape, x, &interpolation.exponents[3 * j]);
      }
      for (std::size_t i = 0; i < n; ++i)
      {
        values[i] = 0.0L;
        for (std::size_t j = 0; j < n; ++j)
        {
          values[i] += interpolation.coefficients[i * n + j] * monomial[j];
        }
      }
    }));
}
} // namespace pixelexact::gmsh
