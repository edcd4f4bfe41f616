// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/ShapeLattice.h"

#include "vtkCellType.h"

#include <glm/matrix.hpp>

#include <array>
#include <initializer_list>
#include <utility>

namespace pixelexact
{
namespace
{
/// A point's numbers along xi, from 0 on.
struct Place
{
  int i;
  int j;
  int k;
  Place operator+(const Place& other) const { return { i + other.i, j + other.j, k + other.k }; }
};

class Maker
{
public:
  Maker(Shape shape, int parts)
    : TheShape(shape)
    , N(parts)
    , Numbers(static_cast<std::size_t>(parts + 1) * (parts + 1) * (parts + 1), -1)
  {
    ForEach([this](const Place& p) { AddPoint(p); });
  }

  ShapeLattice Make()
  {
    ForEach([this](const Place& p) { AddCells(p); });
    return std::move(Lattice);
  }

private:
  template <class Visit>
  void ForEach(const Visit& visit) const
  {
    for (int k = 0; k <= N; ++k)
    {
      for (int j = 0; j <= N; ++j)
      {
        for (int i = 0; i <= N; ++i)
        {
          visit(Place{ i, j, k });
        }
      }
    }
  }

  [[nodiscard]] bool Holds(const Place& p) const
  {
    switch (TheShape)
    {
      case Shape::Hexahedron:
        return p.i <= N && p.j <= N && p.k <= N;
      case Shape::Prism:
        return p.i + p.k <= N && p.j <= N;
      case Shape::Tetrahedron:
        return p.i + p.j + p.k <= N;
      default:
        return p.i + p.k <= N && p.j + p.k <= N;
    }
  }

  void AddPoint(const Place& p)
  {
    if (Holds(p))
    {
      const auto at = [this](int i) { return -1.0 + 2.0 * i / N; };
      NumberOf(p) = static_cast<int>(Lattice.points.size());
      Lattice.points.emplace_back(at(p.i), at(p.j), at(p.k));
    }
  }

  [[nodiscard]] int& NumberOf(const Place& p)
  {
    return Numbers[static_cast<std::size_t>(p.k * (N + 1) + p.j) * (N + 1) + p.i];
  }

  /// Those of its corners that `p` and steps from it are; none where one of them is not in the
  /// shape.
  void AddCell(int type, const Place& p, std::initializer_list<Place> steps)
  {
    std::vector<int> corners;
    for (const Place& step : steps)
    {
      const Place corner = p + step;
      if (!Holds(corner))
      {
        return;
      }
      corners.push_back(NumberOf(corner));
    }
    if (type == VTK_TETRA)
    {
      const auto& x = Lattice.points;
      const Vec3& a = x[corners[0]];
      if (glm::determinant(Mat3(x[corners[1]] - a, x[corners[2]] - a, x[corners[3]] - a)) < 0.0)
      {
        std::swap(corners[2], corners[3]);
      }
    }
    Lattice.types.push_back(static_cast<unsigned char>(type));
    Lattice.corners.insert(Lattice.corners.end(), corners.begin(), corners.end());
    Lattice.offsets.push_back(static_cast<int>(Lattice.corners.size()));
  }

  void AddCells(const Place& p)
  {
    switch (TheShape)
    {
      case Shape::Hexahedron:
        AddCell(VTK_HEXAHEDRON, p,
          { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
            { 1, 1, 1 }, { 0, 1, 1 } });
        break;
      case Shape::Prism:
        AddWedges(p);
        break;
      case Shape::Tetrahedron:
        AddTetrahedra(p);
        break;
      default:
        AddPyramids(p);
    }
  }

  void AddWedges(const Place& p)
  {
    AddCell(VTK_WEDGE, p,
      { { 0, 1, 0 }, { 1, 1, 0 }, { 0, 1, 1 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } });
    AddCell(VTK_WEDGE, p,
      { { 1, 1, 0 }, { 1, 1, 1 }, { 0, 1, 1 }, { 1, 0, 0 }, { 1, 0, 1 }, { 0, 0, 1 } });
  }

  /// Of a cube's six, one at its corner, four about a diagonal of the octahedron in the middle, one
  /// at the opposite corner.
  void AddTetrahedra(const Place& p)
  {
    AddCell(VTK_TETRA, p, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
    constexpr std::array<Place, 4> kAround{ Place{ 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 0 },
      { 0, 1, 0 } };
    for (std::size_t s = 0; s < kAround.size(); ++s)
    {
      AddCell(VTK_TETRA, p, { { 1, 0, 0 }, { 0, 1, 1 }, kAround[s], kAround[(s + 1) % 4] });
    }
    AddCell(VTK_TETRA, p, { { 1, 1, 1 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } });
  }

  /// One that stands on a square of its layer, one that hangs from the next layer's, and tetrahedra
  /// between neighbours that stand.
  void AddPyramids(const Place& p)
  {
    AddCell(VTK_PYRAMID, p, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
    AddCell(VTK_PYRAMID, p, { { 0, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 1, 0, 1 }, { 1, 1, 0 } });
    AddCell(VTK_TETRA, p, { { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 } });
    AddCell(VTK_TETRA, p, { { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 } });
  }

  Shape TheShape;
  int N;
  std::vector<int> Numbers;
  ShapeLattice Lattice;
};
} // namespace

ShapeLattice MakeShapeLattice(Shape shape, int parts)
{
  return Maker(shape, parts).Make();
}
} // namespace pixelexact
