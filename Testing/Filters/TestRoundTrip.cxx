// SPDX-License-Identifier: BSD-3-Clause
// Points mapped forward from random reference coordinates of curved cells of every kind are found
// again, with their value.
#include "Support.h"

#include "Core/Shape/Shape.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkHighOrderProbe.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct StoredCell
{
  int type;
  int points;
  Shape shape;
};

std::ostream& operator<<(std::ostream& os, const StoredCell& kind)
{
  return os << "type " << kind.type << " with " << kind.points << " points";
}

Vec3 BendPoint(const Vec3& x)
{
  return { x.x + 0.05 * std::sin(2 * x.y + x.z), x.y + 0.05 * std::cos(x.x - 2 * x.z),
    x.z + 0.05 * std::sin(x.x + x.y) };
}

/// Our reference coordinates of a node, from VTK's parametric ones.
Vec3 ReferenceOf(const StoredCell& kind, const double* rst)
{
  const Vec3 c(2 * rst[0] - 1, 2 * rst[1] - 1, 2 * rst[2] - 1);
  switch (kind.shape)
  {
    case Shape::Prism:
      return { c.x, -c.z, c.y };
    case Shape::Pyramid:
      // The triquadratic pyramid's coordinates: |c1|, |c2| <= 1 - c3.
      return kind.type == VTK_TRIQUADRATIC_PYRAMID ? Vec3(c.x - c.z, c.y - c.z, 2 * c.z - 1)
                                                   : TensorToReference(kind.shape, c);
    default:
      return c;
  }
}

class RoundTrip : public ::testing::TestWithParam<StoredCell>
{
};

TEST_P(RoundTrip, FindsItsPoints)
{
  const StoredCell kind = GetParam();
  auto grid = OneCell(kind.type, std::vector<double>(3 * kind.points, 0.0));
  const double* rst = grid->GetCell(0)->GetParametricCoords();
  ASSERT_NE(rst, nullptr);
  std::vector<double> xyz;
  std::vector<double> u;
  for (int i = 0; i < kind.points; ++i)
  {
    const Vec3 x = BendPoint(ReferenceOf(kind, rst + 3 * i));
    xyz.insert(xyz.end(), { x.x, x.y, x.z });
    u.push_back(std::cos(x.x) + x.y * x.z);
  }
  grid = OneCell(kind.type, xyz);
  AddPointField(grid, "u", u);
  Conversion conversion(grid);
  ASSERT_TRUE(conversion.done) << conversion.messages->errors;
  EXPECT_EQ(conversion.filter->GetNumberOfDiagnostics(), 0) << conversion.filter->GetDiagnostic(0);

  std::mt19937 random(kind.type);
  std::uniform_real_distribution<double> eta(-1.0, 1.0);
  std::vector<Vec3> xi(200);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (auto& at : xi)
  {
    at = TensorToReference(kind.shape, { eta(random), eta(random), eta(random) });
    double x[3];
    ASSERT_TRUE(conversion.Output()->MapForward(0, &at.x, x));
    points->InsertNextPoint(x);
  }
  vtkNew<vtkPolyData> where;
  where->SetPoints(points);
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(where);
  probe->SetSourceData(conversion.Output());
  probe->Update();
  vtkPointData* found = vtkPolyData::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
  vtkNew<vtkDoubleArray> value;
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    ASSERT_EQ(found->GetArray("Verdict")->GetComponent(at, 0), 1.0) << i;
    ASSERT_TRUE(conversion.Output()->EvaluateField("u", 0, &xi[i].x, value));
    EXPECT_NEAR(found->GetArray("u")->GetComponent(at, 0), value->GetValue(0), 1e-12);
    for (int d = 0; d < 3; ++d)
    {
      // Towards a pyramid's apex xi is less well determined than x.
      EXPECT_NEAR(found->GetArray("Xi")->GetComponent(at, d), xi[i][d], 1e-11) << i;
    }
  }
}

const StoredCell kStoredCells[] = {
  { VTK_TETRA, 4, Shape::Tetrahedron },
  { VTK_QUADRATIC_TETRA, 10, Shape::Tetrahedron },
  { VTK_VOXEL, 8, Shape::Hexahedron },
  { VTK_HEXAHEDRON, 8, Shape::Hexahedron },
  { VTK_QUADRATIC_HEXAHEDRON, 20, Shape::Hexahedron },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, Shape::Hexahedron },
  { VTK_TRIQUADRATIC_HEXAHEDRON, 27, Shape::Hexahedron },
  { VTK_WEDGE, 6, Shape::Prism },
  { VTK_QUADRATIC_LINEAR_WEDGE, 12, Shape::Prism },
  { VTK_QUADRATIC_WEDGE, 15, Shape::Prism },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, Shape::Prism },
  { VTK_PYRAMID, 5, Shape::Pyramid },
  { VTK_QUADRATIC_PYRAMID, 13, Shape::Pyramid },
  { VTK_TRIQUADRATIC_PYRAMID, 19, Shape::Pyramid },
  { VTK_LAGRANGE_TETRAHEDRON, 35, Shape::Tetrahedron },
  { VTK_LAGRANGE_HEXAHEDRON, 125, Shape::Hexahedron },
  { VTK_LAGRANGE_WEDGE, 75, Shape::Prism },
};

INSTANTIATE_TEST_SUITE_P(All, RoundTrip, ::testing::ValuesIn(kStoredCells),
  [](const auto& test) { return "Type" + std::to_string(test.param.type); });
} // namespace
