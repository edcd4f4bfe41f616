// SPDX-License-Identifier: BSD-3-Clause
// Quadratic cells with nodes halfway between straight edges' ends are of order 1, and stay where
// they are.
#include "Support.h"

#include "Core/Shape/Shape.h"
#include "HighOrderModel.h"

#include "vtkCellType.h"
#include "vtkGenericCell.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct StraightCell
{
  int type;
  Shape shape;
};
constexpr std::array kStraightCells{ StraightCell{ VTK_QUADRATIC_TETRA, Shape::Tetrahedron },
  StraightCell{ VTK_QUADRATIC_HEXAHEDRON, Shape::Hexahedron },
  StraightCell{ VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, Shape::Hexahedron },
  StraightCell{ VTK_TRIQUADRATIC_HEXAHEDRON, Shape::Hexahedron },
  StraightCell{ VTK_QUADRATIC_LINEAR_WEDGE, Shape::Prism },
  StraightCell{ VTK_QUADRATIC_WEDGE, Shape::Prism },
  StraightCell{ VTK_BIQUADRATIC_QUADRATIC_WEDGE, Shape::Prism },
  StraightCell{ VTK_QUADRATIC_PYRAMID, Shape::Pyramid } };

/// A straight cell: of xi in the reference shape, by its own kind of linear map.
Vec3 MapStraight(Shape shape, const Vec3& xi)
{
  const Vec3 x = (xi + 1.0) / 2.0;
  Vec3 image(0.7 + 1.1 * x.x - 0.3 * x.y + 0.2 * x.z, -0.4 + 0.2 * x.x + 0.9 * x.y,
    0.3 + 0.1 * x.x - 0.2 * x.y + 1.3 * x.z);
  if (shape == Shape::Hexahedron)
  {
    image +=
      0.1 * x.x * x.y * Vec3(1, 2, -1) + 0.2 * x.y * x.z * Vec3(0, 1, 1) - 0.05 * x.x * x.y * x.z;
  }
  if (shape == Shape::Prism)
  {
    image += 0.1 * x.x * x.y * Vec3(1, 2, -1) - 0.15 * x.z * x.y * Vec3(2, 0, 1);
  }
  return image;
}

/// Reference coordinates of VTK's parametric ones.
Vec3 Reference(Shape shape, const double* rst)
{
  const Vec3 z(2 * rst[0] - 1, 2 * rst[1] - 1, 2 * rst[2] - 1);
  switch (shape)
  {
    case Shape::Prism:
      return { z.x, -z.z, z.y };
    case Shape::Pyramid:
      return TensorToReference(shape, z);
    default:
      return z;
  }
}

/// Nodes are rounded to the points' type. `bulge` moves the last one along y.
vtkSmartPointer<vtkUnstructuredGrid> StraightGrid(
  const StraightCell& kind, double offset, double bulge = 0.0, int pointType = VTK_DOUBLE)
{
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(kind.type);
  const auto count = cell->GetNumberOfPoints();
  auto grid = OneCell(kind.type, std::vector<double>(3 * static_cast<std::size_t>(count)));
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  std::vector<double> field;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vec3 x =
      offset + MapStraight(kind.shape, Reference(kind.shape, cell->GetParametricCoords() + 3 * i));
    points->InsertNextPoint(x.x, x.y + (i + 1 == count ? bulge : 0.0), x.z);
    field.push_back(static_cast<double>(i * i));
  }
  grid->SetPoints(points);
  AddPointField(grid, "u", field);
  return grid;
}

int GeometryOrder(vtkUnstructuredGrid* grid)
{
  int range[2];
  Converted(grid)->GetGeometryOrderRange(range);
  return range[1];
}

TEST(StraightCells, AreOfOrderOneAndStayInPlace)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> eta(-1.0, 1.0);
  for (const StraightCell& kind : kStraightCells)
  {
    for (const double offset : { 0.0, 1e6 })
    {
      const auto output = Converted(StraightGrid(kind, offset));
      int range[2];
      output->GetGeometryOrderRange(range);
      EXPECT_EQ(range[1], 1) << "type " << kind.type << " at " << offset;
      output->GetFieldOrderRange("u", range);
      EXPECT_EQ(range[1], 2) << "fields are never reduced";
      const double uncertainty = HighOrderModel::From(output)->GetMesh().uncertainty[0];
      // The nodes' roundings, 4 of each, amplified by the change of basis.
      EXPECT_LE(uncertainty, 2e-14 * (1.0 + offset)) << "type " << kind.type;
      for (int trial = 0; trial < 20; ++trial)
      {
        const Vec3 at = TensorToReference(kind.shape, { eta(random), eta(random), eta(random) });
        const double xi[3] = { at.x, at.y, at.z };
        double x[3];
        ASSERT_TRUE(output->MapForward(0, xi, x));
        const Vec3 expected = MapStraight(kind.shape, at);
        for (int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(x[d] - offset, expected[d], uncertainty + 1e-16 * (1.0 + offset))
            << "type " << kind.type;
        }
      }
    }
    EXPECT_EQ(GeometryOrder(StraightGrid(kind, 0.0, 0.0, VTK_FLOAT)), 1) << "type " << kind.type;
  }
}

TEST(StraightCells, ABulgeAboveRoundingIsKept)
{
  for (const StraightCell& kind : kStraightCells)
  {
    EXPECT_EQ(GeometryOrder(StraightGrid(kind, 0.0, 1e-13)), 2) << "type " << kind.type;
  }
}
TEST(StraightCells, MeetCurvedNeighboursWhereTheyDid)
{
  // A hexahedron with a curved far side next to the straight one; both share the nodes of their
  // face.
  const StraightCell kind{ VTK_QUADRATIC_HEXAHEDRON, Shape::Hexahedron };
  const auto straight = StraightGrid(kind, 0.0);
  const auto curved = StraightGrid(kind, 0.0);
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(kind.type);
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    const double* rst = cell->GetParametricCoords() + 3 * i;
    const Vec3 x = MapStraight(kind.shape, Reference(kind.shape, rst) + Vec3(2, 0, 0));
    curved->GetPoints()->SetPoint(i, x.x + 0.2 * rst[0] * rst[1] * (1 - rst[1]), x.y, x.z);
  }
  EXPECT_EQ(GeometryOrder(straight), 1);
  EXPECT_EQ(GeometryOrder(curved), 2);
  const auto a = Converted(straight);
  const auto b = Converted(curved);
  const double allowed = HighOrderModel::From(a)->GetMesh().uncertainty[0] +
    HighOrderModel::From(b)->GetMesh().uncertainty[0];
  EXPECT_LE(allowed, 1e-13);
  for (double y = -1.0; y <= 1.0; y += 0.25)
  {
    for (double z = -1.0; z <= 1.0; z += 0.25)
    {
      const double left[3] = { 1.0, y, z };
      const double right[3] = { -1.0, y, z };
      double p[3];
      double q[3];
      ASSERT_TRUE(a->MapForward(0, left, p));
      ASSERT_TRUE(b->MapForward(0, right, q));
      for (int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(p[d], q[d], allowed);
      }
    }
  }
}
} // namespace
