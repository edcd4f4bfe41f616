// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/ShapeLattice.h"

#include "Cells/LinearCell.h"
#include "Core/Location/Sample.h"

#include "vtkCellType.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace pixelexact
{
namespace
{
/// A point's numbers along xi, from 0 on.
struct LatticePlace
{
  int i;
  int j;
  int k;
  LatticePlace operator+(const LatticePlace& other) const
  {
    return { i + other.i, j + other.j, k + other.k };
  }
};

class Maker
{
public:
  Maker(Shape shape, int parts)
    : shape_(shape)
    , N(parts)
    , Numbers(static_cast<std::size_t>(parts + 1) * (parts + 1) * (parts + 1), -1)
  {
    ForEach([this](const LatticePlace& p) { AddPoint(p); });
  }

  ShapeLattice Make()
  {
    ForEach([this](const LatticePlace& p) { AddCells(p); });
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
          visit(LatticePlace{ i, j, k });
        }
      }
    }
  }

  [[nodiscard]] bool Holds(const LatticePlace& p) const
  {
    switch (shape_)
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

  void AddPoint(const LatticePlace& p)
  {
    if (Holds(p))
    {
      const auto at = [this](int i) { return -1.0 + 2.0 * i / N; };
      NumberOf(p) = static_cast<int>(Lattice.points.size());
      Lattice.points.emplace_back(at(p.i), at(p.j), at(p.k));
    }
  }

  [[nodiscard]] int& NumberOf(const LatticePlace& p)
  {
    return Numbers[static_cast<std::size_t>(p.k * (N + 1) + p.j) * (N + 1) + p.i];
  }

  /// Adds the cell with corners at `p` and at steps from it; nothing where a corner is outside of
  /// the shape.
  void AddCell(int type, const LatticePlace& p, std::initializer_list<LatticePlace> steps)
  {
    std::vector<int> corners;
    for (const LatticePlace& step : steps)
    {
      const LatticePlace corner = p + step;
      if (!Holds(corner))
      {
        return;
      }
      corners.push_back(NumberOf(corner));
    }
    std::vector<Vec3> places;
    std::ranges::transform(corners, std::back_inserter(places),
      [this](int corner) { return Lattice.points[static_cast<std::size_t>(corner)]; });
    if (VolumeOf(type, places) < 0.0)
    {
      Mirror(std::span(corners));
    }
    Lattice.types.push_back(static_cast<unsigned char>(type));
    Lattice.corners.insert(Lattice.corners.end(), corners.begin(), corners.end());
    Lattice.offsets.push_back(static_cast<int>(Lattice.corners.size()));
  }

  void AddCells(const LatticePlace& p)
  {
    switch (shape_)
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

  void AddWedges(const LatticePlace& p)
  {
    AddCell(VTK_WEDGE, p,
      { { 0, 1, 0 }, { 1, 1, 0 }, { 0, 1, 1 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } });
    AddCell(VTK_WEDGE, p,
      { { 1, 1, 0 }, { 1, 1, 1 }, { 0, 1, 1 }, { 1, 0, 0 }, { 1, 0, 1 }, { 0, 0, 1 } });
  }

  /// Adds those of a cube's six tetrahedra that are in the shape: one at its corner, four about a
  /// diagonal of the octahedron in the middle, one at the opposite corner.
  void AddTetrahedra(const LatticePlace& p)
  {
    AddCell(VTK_TETRA, p, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
    constexpr std::array<LatticePlace, 4> kAround{ LatticePlace{ 0, 0, 1 }, { 1, 0, 1 },
      { 1, 1, 0 }, { 0, 1, 0 } };
    for (std::size_t s = 0; s < kAround.size(); ++s)
    {
      AddCell(VTK_TETRA, p, { { 1, 0, 0 }, { 0, 1, 1 }, kAround[s], kAround[(s + 1) % 4] });
    }
    AddCell(VTK_TETRA, p, { { 1, 1, 1 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } });
  }

  /// Adds a pyramid on a square of its layer, one pointing down from the next layer's square, and
  /// tetrahedra between neighbouring upright pyramids.
  void AddPyramids(const LatticePlace& p)
  {
    AddCell(VTK_PYRAMID, p, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
    AddCell(VTK_PYRAMID, p, { { 0, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 1, 0, 1 }, { 1, 1, 0 } });
    AddCell(VTK_TETRA, p, { { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 } });
    AddCell(VTK_TETRA, p, { { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 } });
  }

  Shape shape_;
  int N;
  std::vector<int> Numbers;
  ShapeLattice Lattice;
};

/// `parts`, n above, at least 1.
[[nodiscard]] ShapeLattice MakeShapeLattice(Shape shape, int parts)
{
  return Maker(shape, parts).Make();
}
} // namespace

const ShapeLattice& LatticeOf(Shape shape, int level)
{
  static PerLevel<ShapeLattice> all;
  return all.Get(shape, level, [&] { return MakeShapeLattice(shape, 1 << level); });
}

std::vector<double> ValuesAt(
  const Mesh& mesh, const Field* field, int element, std::span<const Vec3> xi, int components)
{
  std::vector<double> values(xi.size() * static_cast<std::size_t>(components));
  if (field != nullptr)
  {
    EvaluateAt(mesh, *field, element, xi, values, {});
    return values;
  }
  std::vector<Vec3> x(xi.size());
  MapForward(mesh, element, xi, x);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    std::copy_n(glm::value_ptr(x[i]), 3, &values[3 * i]);
  }
  return values;
}
} // namespace pixelexact
