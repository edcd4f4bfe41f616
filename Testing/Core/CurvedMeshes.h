// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

#include <array>
#include <optional>
#include <span>

// Curved meshes without gap or overlap: the cube [-1,1]^3 cut into straight elements, all bent by
// one polynomial map. Neighbours share their faces exactly, up to the rounding of coefficients,
// whatever their shapes and sizes.
namespace pixelexact::testing
{
/// A polynomial of total degree 3, injective on [-1.2,1.2]^3.
inline LongVec3 Bend(const LongVec3& u)
{
  const auto [a, b, c] = u;
  return { a + 0.11L * b * b - 0.06L * c * a * b + 0.05L * c, b + 0.09L * a * c - 0.05L * a * a * a,
    c + 0.08L * a * b + 0.07L * a * a + 0.03L * b * b * c };
}

/// Position and scale of the bent cube.
struct Placement
{
  LongVec3 scale{ 1.0L, 1.0L, 1.0L };
  LongVec3 offset{ 0.0L, 0.0L, 0.0L };

  [[nodiscard]] LongVec3 operator()(const LongVec3& u) const
  {
    LongVec3 x = Bend(u);
    for (int d = 0; d < 3; ++d)
    {
      x[d] = offset[d] + scale[d] * x[d];
    }
    return x;
  }
};

/// A cube that is as flat as a boundary layer.
inline const Placement kThinPlacement{ { 1.0L, 1e-3L, 1.0L }, { 0.0L, 0.0L, 0.0L } };
/// Some hundred sizes away from the origin.
inline const Placement kFarPlacement{ { 0.01L, 0.01L, 0.01L }, { 3.0L, -7.0L, 5.0L } };

// Shapes of the blocks of a mesh.
inline constexpr Shape kHexahedra[] = { Shape::Hexahedron };
inline constexpr Shape kPrisms[] = { Shape::Prism };
inline constexpr Shape kTetrahedra[] = { Shape::Tetrahedron };
inline constexpr Shape kPyramids[] = { Shape::Pyramid };
/// Every shape meets every other one.
inline constexpr Shape kMixed[] = { Shape::Hexahedron, Shape::Pyramid, Shape::Tetrahedron,
  Shape::Prism, Shape::Tetrahedron };

/// An axis-aligned box of the cube.
struct CubeBox
{
  std::array<double, 3> lower;
  double side;

  /// A corner or face centre; i, j, k are 0, 1, 2 for low, middle and high.
  [[nodiscard]] LongVec3 At(int i, int j, int k) const
  {
    return { lower[0] + side / 2 * i, lower[1] + side / 2 * j, lower[2] + side / 2 * k };
  }
};

class CurvedMesh
{
public:
  explicit CurvedMesh(const Placement& place)
    : Place(place)
  {
  }

  /// Fills the block with elements of this shape: one hexahedron, 2 prisms, 6 tetrahedra about the
  /// diagonal or 6 pyramids about the centre.
  void Fill(const CubeBox& block, Shape shape)
  {
    switch (shape)
    {
      case Shape::Hexahedron:
        Add(shape, block.At(0, 0, 0), block.At(2, 0, 0), block.At(0, 2, 0), block.At(0, 0, 2));
        break;
      case Shape::Prism:
        Add(shape, block.At(0, 0, 0), block.At(2, 2, 0), block.At(0, 0, 2), block.At(2, 0, 0));
        Add(shape, block.At(0, 0, 0), block.At(2, 2, 0), block.At(0, 0, 2), block.At(0, 2, 0));
        break;
      case Shape::Tetrahedron:
        AddTetrahedra(block);
        break;
      default:
        for (int axis = 0; axis < 3; ++axis)
        {
          AddPyramid(block, axis, 0);
          AddPyramid(block, axis, 2);
        }
    }
  }

  [[nodiscard]] Mesh View() const { return Builder.View(); }
  [[nodiscard]] const Placement& Placed() const { return Place; }

private:
  void AddTetrahedra(const CubeBox& block)
  {
    const int order[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
      { 2, 1, 0 } };
    for (const auto& axes : order)
    {
      int at[3] = { 0, 0, 0 };
      at[axes[0]] = 2;
      const LongVec3 first = block.At(at[0], at[1], at[2]);
      at[axes[1]] = 2;
      const LongVec3 second = block.At(at[0], at[1], at[2]);
      Add(Shape::Tetrahedron, block.At(0, 0, 0), first, second, block.At(2, 2, 2));
    }
  }

  void AddPyramid(const CubeBox& block, int axis, int side)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto corner = [&](int i, int j)
    {
      int at[3];
      at[axis] = side;
      at[u] = i;
      at[v] = j;
      return block.At(at[0], at[1], at[2]);
    };
    Add(Shape::Pyramid, corner(0, 0), corner(2, 0), corner(0, 2), block.At(1, 1, 1));
  }

  /// Adds the element with the vertex xi = (-1,-1,-1) at `origin` and its neighbours along xi_i at
  /// the other points. Swaps two axes of the base where that makes it right-handed.
  void Add(Shape shape, const LongVec3& origin, const LongVec3& first, const LongVec3& second,
    const LongVec3& third)
  {
    LongVec3 a = Minus(first, origin);
    LongVec3 b = Minus(second, origin);
    LongVec3 c = Minus(third, origin);
    const long double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) +
      a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    if (volume < 0)
    {
      std::swap(a, shape == Shape::Prism ? c : b);
    }
    const auto map = [=, this](const LongVec3& xi)
    {
      LongVec3 u = origin;
      for (int d = 0; d < 3; ++d)
      {
        u[d] += (a[d] * (1 + xi[0]) + b[d] * (1 + xi[1]) + c[d] * (1 + xi[2])) / 2;
      }
      return Place(u);
    };
    const Vec3 centre = ToDouble(map(ToLong(Centre(shape))));
    const long double extent =
      std::max({ Place.scale[0], Place.scale[1], Place.scale[2] }) * std::max(Length(a), Length(c));
    Builder.Add(UniformSpace(shape, 3), map, centre,
      std::exp2(std::round(std::log2(static_cast<double>(extent / 2)))));
  }

  static long double Length(const LongVec3& v)
  {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }

  Placement Place;
  MeshBuilder Builder;
};

/// n x n x n blocks; block i gets shape i of the list, counted round.
inline CurvedMesh Blocks(int n, std::span<const Shape> shapes, const Placement& place = {})
{
  CurvedMesh mesh(place);
  for (int i = 0; i < n * n * n; ++i)
  {
    const double side = 2.0 / n;
    const int row = i / n % n;
    const int layer = i / n / n;
    mesh.Fill({ { -1 + side * (i % n), -1 + side * row, -1 + side * layer }, side },
      shapes[static_cast<std::size_t>(i) % shapes.size()]);
  }
  return mesh;
}

/// 2 x 2 x 2 blocks, every other one refined into 8, one of those once more: hanging nodes on faces
/// and edges, of one shape or of several.
inline CurvedMesh Hanging(std::span<const Shape> shapes, const Placement& place = {})
{
  CurvedMesh mesh(place);
  std::size_t count = 0;
  const auto fill = [&](const CubeBox& block)
  { mesh.Fill(block, shapes[count++ % shapes.size()]); };
  const auto octant = [](const CubeBox& block, int i)
  {
    const double half = block.side / 2;
    const int row = i / 2 % 2;
    const int layer = i / 4;
    return CubeBox{ { block.lower[0] + half * (i % 2), block.lower[1] + half * row,
                      block.lower[2] + half * layer },
      half };
  };
  const CubeBox cube{ { -1, -1, -1 }, 2 };
  for (int i = 0; i < 8; ++i)
  {
    const CubeBox block = octant(cube, i);
    const bool refined = (i % 2 + i / 2 % 2 + i / 4) % 2 == 1;
    for (int k = 0; refined && k < 8; ++k)
    {
      const CubeBox small = octant(block, k);
      for (int m = 0; i == 1 && k == 5 && m < 8; ++m)
      {
        fill(octant(small, m));
      }
      if (i != 1 || k != 5)
      {
        fill(small);
      }
    }
    if (!refined)
    {
      fill(block);
    }
  }
  return mesh;
}
} // namespace pixelexact::testing
