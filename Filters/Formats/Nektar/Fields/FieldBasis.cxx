// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Fields/FieldBasis.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Geometry/ReferenceShapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace pixelexact::nektar
{
namespace
{
/// Dense changes of basis beyond this take minutes.
constexpr int kMaxDenseModes = 2000;

LineFunctions LineOf(const std::string& family, int count)
{
  if (family == "GLL_Lagrange" && count >= 2)
  {
    return Lagrange(GaussLobattoPoints(count));
  }
  if (family == "Gauss_Lagrange")
  {
    return Lagrange(GaussPoints(count));
  }
  if (family == "Modified_A")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = ModifiedA(n, z);
        }
      } };
  }
  if (family == "Ortho_A" || family == "Legendre")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = std::sqrt(n + 0.5L) * std::legendre(n, z);
        }
      } };
  }
  if (family == "Chebyshev")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = std::cos(n * std::acos(std::clamp(z, -1.0L, 1.0L)));
        }
      } };
  }
  if (family == "Monomial")
  {
    return { count,
      [count](long double z, long double* values)
      {
        for (int n = 0; n < count; ++n)
        {
          values[n] = std::pow(z, n);
        }
      } };
  }
  throw Unsupported("the family of functions '" + family.substr(0, 40) +
    "' is not read on hexahedra; Modified_A, Ortho_A, GLL_Lagrange and Gauss_Lagrange are.");
}

/// Across a slab.
LineFunctions ConstantLine()
{
  return { 1, [](long double /*z*/, long double* value) { *value = 1.0L; } };
}

ChangeOfBasis HexahedronChange(const Expansion3& expansion)
{
  Space space{ Shape::Hexahedron, Form::Collapsed, {} };
  std::array<LineFunctions, 3> lines;
  for (int d = 0; d < 3; ++d)
  {
    space.order[d] = static_cast<std::uint8_t>(expansion.count[d] - 1);
    lines[d] = expansion.families[d].empty() ? ConstantLine()
                                             : LineOf(expansion.families[d], expansion.count[d]);
  }
  const auto& n = expansion.count;
  std::vector<int> source;
  for (int i = 0; i < n[0]; ++i)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int k = 0; k < n[2]; ++k)
      {
        source.push_back((k * n[1] + j) * n[0] + i); // p fastest in the file
      }
    }
  }
  return ChangeOfBasis::FromLines(space, lines, source);
}

/// The families that belong to a shape: those of the modified and those of the orthogonal basis.
bool IsFamily(const Expansion3& expansion, const char* kind)
{
  const std::string a = std::string(kind) + "_A";
  const std::string b = std::string(kind) + "_B";
  const std::string c = std::string(kind) + "_C";
  const std::string pyramid = std::string(kind) + "Pyr_C";
  const auto& f = expansion.families;
  switch (expansion.shape)
  {
    case Shape::Prism:
      return f[0] == a && (f[1] == a || expansion.IsPlane()) && f[2] == b;
    case Shape::Tetrahedron:
      return f[0] == a && f[1] == b && f[2] == c;
    default:
      return f[0] == a && f[1] == a && (f[2] == pyramid || f[2] == c);
  }
}

void RequireNestedOrders(const Expansion3& expansion)
{
  const auto [p, q, r] = expansion.count;
  const bool sound = expansion.shape == Shape::Prism ? p <= r
    : expansion.shape == Shape::Tetrahedron          ? p <= q && q <= r
                                                     : std::max(p, q) <= r;
  if (!sound)
  {
    throw InvalidData("the numbers of modes " + std::to_string(p) + ", " + std::to_string(q) +
      ", " + std::to_string(r) + " are not nested as a " + NameOf(expansion) + " needs them.");
  }
}

/// Functions on a shape, in the smallest canonical space that holds them: orders `order`, on
/// pyramids the collapsed form if it will do, otherwise the tensor form.
ChangeOfBasis ChangeInto(Shape shape, const std::array<int, 3>& order, int functions,
  const std::function<void(const LongVec3&, long double*)>& evaluate)
{
  Space space{ shape, Form::Collapsed, {} };
  std::ranges::copy(order, space.order.begin());
  if (space.Modes() > kMaxDenseModes)
  {
    throw Unsupported("elements of " + std::to_string(space.Modes()) +
      " modes are not read; up to " + std::to_string(kMaxDenseModes) + " are.");
  }
  if (shape != Shape::Pyramid)
  {
    return ChangeOfBasis::FromFunctions(space, functions, evaluate);
  }
  // The factor ((1 - z) / 2)^(p + q - 2) of Nektar++'s inner functions may exceed the collapsed
  // space; a tensor space holds every one of them.
  try
  {
    return ChangeOfBasis::FromFunctions(space, functions, evaluate);
  }
  catch (const InvalidData&)
  {
    const int lower = std::min(order[0], order[1]);
    space.form = Form::Tensor;
    space.order[2] = static_cast<std::uint8_t>(order[2] + std::max(0, lower - 2));
    return ChangeOfBasis::FromFunctions(space, functions, evaluate);
  }
}

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

/// The factor from values at a face's nodes to the coefficients of the modes that do not vanish on
/// it.
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

ElementBasis MakeFieldBasis(const Expansion3& expansion)
{
  ElementBasis basis;
  const auto modes = ModesOf(expansion.shape, expansion.count);
  basis.sources = static_cast<int>(modes.size());
  if (expansion.shape == Shape::Hexahedron)
  {
    basis.parts.push_back(HexahedronChange(expansion));
    return basis;
  }
  const bool modified = IsFamily(expansion, "Modified");
  if (!modified && !IsFamily(expansion, "Ortho"))
  {
    throw Unsupported("the basis " + Describe(expansion) + " on a " + NameOf(expansion) +
      " is not read; the modified and the orthogonal ones are.");
  }
  RequireNestedOrders(expansion);
  const auto function = modified ? &ModifiedMode : &OrthogonalMode;
  const auto& n = expansion.count;
  basis.parts.push_back(ChangeInto(expansion.shape, { n[0] - 1, n[1] - 1, n[2] - 1 }, basis.sources,
    [&](const LongVec3& xi, long double* values)
    {
      // A triangle's functions are a prism's functions at one end, up to the value of the line's
      // function.
      const LongVec3 at = expansion.IsPlane() ? LongVec3{ xi[0], -1, xi[2] } : xi;
      const long double across = expansion.IsPlane() && !modified ? std::sqrt(0.5L) : 1.0L;
      for (const Mode& mode : modes)
      {
        *values++ = function(expansion.shape, mode, at) / across;
      }
    }));
  return basis;
}

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
