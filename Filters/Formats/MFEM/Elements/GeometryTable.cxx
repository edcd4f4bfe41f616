// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/GeometryTable.h"

#include "Core/Base/Error.h"

namespace pixelexact::mfem
{
namespace
{
using Edge = std::array<int, 2>;
constexpr auto kTriangle = Geometry::Triangle;
constexpr auto kSquare = Geometry::Square;

constexpr std::array<Edge, 3> kTriangleEdges{ Edge{ 0, 1 }, { 1, 2 }, { 2, 0 } };
constexpr std::array<std::int8_t, 3> kTriangleSides{ 2, 3, 4 };
constexpr std::array<Edge, 4> kSquareEdges{ Edge{ 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
constexpr std::array<std::int8_t, 4> kSquareSides{ 2, 1, 3, 0 };

constexpr std::array<Edge, 6> kTetrahedronEdges{ Edge{ 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 },
  { 1, 3 }, { 2, 3 } };
constexpr std::array<LocalFace, 4> kTetrahedronFaces{ LocalFace{ kTriangle, { 1, 2, 3, -1 }, 1 },
  { kTriangle, { 0, 3, 2, -1 }, 2 }, { kTriangle, { 0, 1, 3, -1 }, 0 },
  { kTriangle, { 0, 2, 1, -1 }, 3 } };

constexpr std::array<Edge, 12> kCubeEdges{ Edge{ 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 4, 5 },
  { 5, 6 }, { 7, 6 }, { 4, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
constexpr std::array<LocalFace, 6> kCubeFaces{ LocalFace{ kSquare, { 3, 2, 1, 0 }, 4 },
  { kSquare, { 0, 1, 5, 4 }, 2 }, { kSquare, { 1, 2, 6, 5 }, 1 }, { kSquare, { 2, 3, 7, 6 }, 3 },
  { kSquare, { 3, 0, 4, 7 }, 0 }, { kSquare, { 4, 5, 6, 7 }, 5 } };

constexpr std::array<Edge, 9> kPrismEdges{ Edge{ 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 },
  { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } };
constexpr std::array<LocalFace, 5> kPrismFaces{ LocalFace{ kTriangle, { 0, 2, 1, -1 }, 0 },
  { kTriangle, { 3, 4, 5, -1 }, 1 }, { kSquare, { 0, 1, 4, 3 }, 2 }, { kSquare, { 1, 2, 5, 4 }, 3 },
  { kSquare, { 2, 0, 3, 5 }, 4 } };

constexpr std::array<Edge, 8> kPyramidEdges{ Edge{ 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 0, 4 },
  { 1, 4 }, { 2, 4 }, { 3, 4 } };
constexpr std::array<LocalFace, 5> kPyramidFaces{ LocalFace{ kSquare, { 3, 2, 1, 0 }, 0 },
  { kTriangle, { 0, 1, 4, -1 }, 1 }, { kTriangle, { 1, 2, 4, -1 }, 2 },
  { kTriangle, { 2, 3, 4, -1 }, 3 }, { kTriangle, { 3, 0, 4, -1 }, 4 } };
} // namespace

const GeometryTable& TableOf(Geometry geometry)
{
  static const GeometryTable segment{ 2, {}, {} };
  static const GeometryTable triangle{ 3, kTriangleEdges, {}, kTriangleSides };
  static const GeometryTable square{ 4, kSquareEdges, {}, kSquareSides };
  static const GeometryTable tetrahedron{ 4, kTetrahedronEdges, kTetrahedronFaces };
  static const GeometryTable cube{ 8, kCubeEdges, kCubeFaces };
  static const GeometryTable prism{ 6, kPrismEdges, kPrismFaces };
  static const GeometryTable pyramid{ 5, kPyramidEdges, kPyramidFaces };
  switch (geometry)
  {
    case Geometry::Segment:
      return segment;
    case Geometry::Triangle:
      return triangle;
    case Geometry::Square:
      return square;
    case Geometry::Tetrahedron:
      return tetrahedron;
    case Geometry::Cube:
      return cube;
    case Geometry::Prism:
      return prism;
    case Geometry::Pyramid:
      return pyramid;
    default:
      throw Error("points have no table.");
  }
}
} // namespace pixelexact::mfem
