// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/BlockParts.h"

#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
using PartCorners = std::vector<Vec3>;

/// Corners of the unit cube's parts. Hexahedron: 8, x fastest. Prism: the triangle of (xi1, xi3),
/// then the same at the other end of xi2. Pyramid: the base, xi1 fastest, and the apex.
std::vector<std::vector<Vec3>> PartsOfCube(Shape shape)
{
  const auto corner = [](int bits) { return Vec3(bits & 1, bits >> 1 & 1, bits >> 2 & 1); };
  std::vector<std::vector<Vec3>> parts;
  switch (shape)
  {
    case Shape::Hexahedron:
      parts.emplace_back();
      for (int bits = 0; bits < 8; ++bits)
      {
        parts.back().push_back(corner(bits));
      }
      break;
    case Shape::Prism:
      for (const auto& [a, b, c] : { std::array{ 0, 1, 4 }, std::array{ 5, 4, 1 } })
      {
        parts.push_back(
          { corner(a), corner(b), corner(c), corner(a + 2), corner(b + 2), corner(c + 2) });
      }
      break;
    case Shape::Tetrahedron:
      // One tetrahedron along the diagonal from 0 to 7 for each order of the axes.
      for (const auto& [a, b] : { std::array{ 1, 2 }, std::array{ 2, 4 }, std::array{ 4, 1 },
             std::array{ 2, 1 }, std::array{ 4, 2 }, std::array{ 1, 4 } })
      {
        const bool even = (a == 1 && b == 2) || (a == 2 && b == 4) || (a == 4 && b == 1);
        const Vec3 first = corner(a);
        const Vec3 second = corner(a + b);
        parts.push_back(even ? PartCorners{ corner(0), first, second, corner(7) }
                             : PartCorners{ corner(0), second, first, corner(7) });
      }
      break;
    default:
      for (int axis = 0; axis < 3; ++axis)
      {
        for (int end = 0; end < 2; ++end)
        {
          const int u = 1 << (axis + 1) % 3;
          const int v = 1 << (axis + 2) % 3;
          const int at = end << axis;
          // The base's second direction turns with its end: no map is mirrored.
          parts.push_back(end == 0
              ? PartCorners{ corner(at), corner(at + u), corner(at + v), corner(at + u + v) }
              : PartCorners{ corner(at), corner(at + v), corner(at + u), corner(at + u + v) });
          parts.back().emplace_back(0.5);
        }
      }
  }
  return parts;
}

/// The functions of order 1 that are 1 at one corner of a shape and 0 at the others.
void CornerFunctions(Shape shape, const LongVec3& xi, long double* value)
{
  const auto half = [](long double z) { return 0.5L * (1.0L + z); };
  const auto bilinear = [&value](long double a, long double b, long double weight)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      *value++ = (corner % 2 == 1 ? a : 1 - a) * (corner / 2 == 1 ? b : 1 - b) * weight;
    }
  };
  const long double u = half(xi[0]);
  const long double v = half(xi[1]);
  const long double w = half(xi[2]);
  switch (shape)
  {
    case Shape::Hexahedron:
      bilinear(u, v, 1 - w);
      bilinear(u, v, w);
      return;
    case Shape::Prism:
      for (const long double line : { 1 - v, v })
      {
        *value++ = (1 - u - w) * line;
        *value++ = u * line;
        *value++ = w * line;
      }
      return;
    case Shape::Tetrahedron:
      *value++ = 1 - u - v - w;
      *value++ = u;
      *value++ = v;
      *value++ = w;
      return;
    default:
      // The values are rational in xi. The apex, where they are undefined, is not evaluated.
      bilinear(u / (1 - w), v / (1 - w), 1 - w);
      *value++ = w;
  }
}

/// The images of the origin and the axes, for a part that is an affine image of the reference shape
/// with corners at 0 and 1.
struct CornerMap
{
  Vec3 origin;
  Vec3 axis[3];
};

CornerMap CornerMapOf(Shape shape, const PartCorners& c)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return { c[0], { c[1] - c[0], c[2] - c[0], c[4] - c[0] } };
    case Shape::Prism:
      return { c[0], { c[1] - c[0], c[3] - c[0], c[2] - c[0] } };
    case Shape::Tetrahedron:
      return { c[0], { c[1] - c[0], c[2] - c[0], c[3] - c[0] } };
    default:
      return { c[0], { c[1] - c[0], c[2] - c[0], c[4] - c[0] } };
  }
}

constexpr int kCubicNodes = 20;

/// Lattice of the cubic polynomials' nodes, in thirds of the axes.
std::vector<std::array<int, 3>> CubicLattice()
{
  std::vector<std::array<int, 3>> nodes;
  nodes.reserve(kCubicNodes);
  for (int i = 0; i <= 3; ++i)
  {
    for (int j = 0; j <= 3 - i; ++j)
    {
      for (int k = 0; k <= 3 - i - j; ++k)
      {
        nodes.push_back({ i, j, k });
      }
    }
  }
  return nodes;
}

/// Lagrange's polynomials of degree 3 on that lattice, which every space of order 3 holds.
void CubicFunctions(const LongVec3& xi, long double* value)
{
  static const auto kLattice = CubicLattice();
  const long double r[3] = { 0.5L * (1 + xi[0]), 0.5L * (1 + xi[1]), 0.5L * (1 + xi[2]) };
  const auto factor = [](long double barycentric, int n)
  {
    long double product = 1.0L;
    for (int m = 0; m < n; ++m)
    {
      product *= (3 * barycentric - m) / (m + 1);
    }
    return product;
  };
  for (const auto& [i, j, k] : kLattice)
  {
    *value++ = factor(r[0], i) * factor(r[1], j) * factor(r[2], k) *
      factor(1 - r[0] - r[1] - r[2], 3 - i - j - k);
  }
}

Vec3 Bend(const Vec3& x)
{
  return x +
    0.08 *
    Vec3(x.y * x.y * x.z + 0.5 * x.z * x.z, x.z * x.z * x.x - 0.5 * x.x * x.y,
      x.x * x.x * x.y + 0.5 * x.y * x.y);
}

/// Moves a lattice corner by less than a twentieth of a cell, always by the same vector.
Vec3 Moved(const Vec3& at)
{
  const auto noise = [&](double a, double b, double c)
  { return 0.05 * std::sin(12.9898 * a * at.x + 78.233 * b * at.y + 37.719 * c * at.z); };
  return at + Vec3(noise(1, 2, 3), noise(3, 1, 2), noise(2, 3, 1));
}
} // namespace

BlockParts::BlockParts(Shape shape, bool curved)
  : shape_(shape)
  , Curved(curved)
  , OfCube(PartsOfCube(shape))
  , Basis(ChangeOfBasis::FromFunctions(UniformSpace(shape, curved ? 3 : 1),
      curved ? kCubicNodes : static_cast<int>(OfCube[0].size()),
      [&](const LongVec3& xi, long double* value)
      { curved ? CubicFunctions(xi, value) : CornerFunctions(shape, xi, value); }))
{
}

std::vector<Vec3> BlockParts::SourceValues(int part, const Vec3& at, int side) const
{
  const PartCorners& corners = OfCube[static_cast<std::size_t>(part)];
  const auto toWorld = [side](const Vec3& lattice) { return 2.0 / side * lattice - 1.0; };
  std::vector<Vec3> values;
  if (!Curved)
  {
    for (const Vec3& corner : corners)
    {
      values.push_back(toWorld(Moved(at + corner)));
    }
    return values;
  }
  const CornerMap frame = CornerMapOf(shape_, corners);
  for (const auto& [i, j, k] : CubicLattice())
  {
    values.push_back(Bend(toWorld(at + frame.origin +
      (1.0 / 3.0) *
        (double(i) * frame.axis[0] + double(j) * frame.axis[1] + double(k) * frame.axis[2]))));
  }
  return values;
}
} // namespace pixelexact
