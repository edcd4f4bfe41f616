// SPDX-License-Identifier: BSD-3-Clause
// The map of each kind of cell against VTK's own interpolation functions, with nodes anywhere.
#include "Support.h"

#include "Core/Shape/Shape.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIntArray.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct BasisCell
{
  int type;
  int points;
  Shape shape;
  std::array<int, 3> degrees{ 0, 0, 0 };
  bool isPlane = false; ///< in z = kHeight
};

constexpr double kHeight = 0.3;

std::ostream& operator<<(std::ostream& os, const BasisCell& kind)
{
  return os << "type " << kind.type << " with " << kind.points << " points";
}

/// Parametric and reference coordinates of the same random point of the shape.
struct Place
{
  std::array<double, 3> vtk{};
  std::array<double, 3> xi{};

  Place(const BasisCell& kind, std::mt19937& random)
  {
    std::uniform_real_distribution<double> unit(0.01, 0.99);
    const auto eta = [&] { return 2.0 * unit(random) - 1.0; };
    const Vec3 tensor(eta(), eta(), eta());
    const Vec3 at = TensorToReference(kind.shape, tensor);
    xi = { at.x, at.y, at.z };
    const auto half = [](double v) { return (1.0 + v) / 2.0; };
    switch (kind.shape)
    {
      case Shape::Prism:
        vtk = { half(at.x), half(at.z), half(-at.y) };
        break;
      case Shape::Pyramid:
      {
        // The triquadratic pyramid's coordinates are those of the pyramid, upper half of the cube.
        const double T = half(tensor.z);
        vtk = { half(tensor.x), half(tensor.y), T };
        if (kind.type == VTK_TRIQUADRATIC_PYRAMID)
        {
          vtk = { half(tensor.x * (1.0 - T)), half(tensor.y * (1.0 - T)), half(T) };
        }
        break;
      }
      default:
        vtk = { half(at.x), half(at.y), half(at.z) };
    }
  }
};

class CellBasis : public ::testing::TestWithParam<BasisCell>
{
};

TEST_P(CellBasis, MapsAsVtkDoes)
{
  const BasisCell kind = GetParam();
  std::mt19937 random(kind.type * 10000 + kind.points);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  std::vector<double> xyz(3 * kind.points);
  std::vector<double> values(kind.points);
  std::ranges::generate(xyz, [&] { return anywhere(random); });
  std::ranges::generate(values, [&] { return anywhere(random); });
  for (std::size_t i = 2; kind.isPlane && i < xyz.size(); i += 3)
  {
    xyz[i] = kHeight;
  }
  const auto grid = OneCell(kind.type, xyz);
  AddPointField(grid, "u", values);
  if (kind.degrees[0] > 0)
  {
    vtkNew<vtkIntArray> degrees;
    degrees->SetName("HigherOrderDegrees");
    degrees->SetNumberOfComponents(3);
    degrees->InsertNextTypedTuple(kind.degrees.data());
    grid->GetCellData()->SetHigherOrderDegrees(degrees);
  }
  Conversion conversion(grid);
  ASSERT_EQ(conversion.messages->errors, "");
  ASSERT_TRUE(conversion.done);

  vtkCell* cell = grid->GetCell(0);
  std::vector<double> weights(kind.points);
  vtkNew<vtkDoubleArray> found;
  for (int trial = 0; trial < 20; ++trial)
  {
    const Place place(kind, random);
    cell->InterpolateFunctions(place.vtk.data(), weights.data());
    std::array<double, 3> x{};
    ASSERT_TRUE(conversion.Output()->MapForward(0, place.xi.data(), x.data()));
    ASSERT_TRUE(conversion.Output()->EvaluateField("u", 0, place.xi.data(), found));
    double expected[4] = { 0.0, 0.0, 0.0, 0.0 };
    double sum = 0.0;
    for (int i = 0; i < kind.points; ++i)
    {
      sum += std::fabs(weights[i]);
      for (int d = 0; d < 3; ++d)
      {
        expected[d] += weights[i] * xyz[3 * i + d];
      }
      expected[3] += weights[i] * values[i];
    }
    // VTK's own functions, in double, set the limit.
    const double tolerance = 2e-13 * sum * std::cbrt(kind.points);
    for (int d = 0; d < (kind.isPlane ? 2 : 3); ++d)
    {
      EXPECT_NEAR(x[d], expected[d], tolerance);
    }
    if (kind.isPlane)
    {
      // The thickness is between a 64th of 2 and zero, because the box is smaller than that of all
      // possible points.
      EXPECT_LE(std::fabs(x[2] - kHeight), 1.0 / 32);
    }
    EXPECT_NEAR(found->GetValue(0), expected[3], tolerance);
  }
}

std::vector<BasisCell> Kinds()
{
  std::vector<BasisCell> kinds{
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
    { VTK_LAGRANGE_TETRAHEDRON, 15, Shape::Tetrahedron },
    { VTK_LAGRANGE_WEDGE, 21, Shape::Prism },
    { VTK_LAGRANGE_HEXAHEDRON, 5 * 3 * 4, Shape::Hexahedron, { 4, 2, 3 } },
    { VTK_BEZIER_HEXAHEDRON, 3 * 2 * 5, Shape::Hexahedron, { 2, 1, 4 } },
    { VTK_LAGRANGE_WEDGE, 10 * 6, Shape::Prism, { 3, 3, 5 } },
    { VTK_BEZIER_WEDGE, 15 * 3, Shape::Prism, { 4, 4, 2 } },
  };
  const std::array none{ 0, 0, 0 };
  for (const auto& [type, points] : { std::pair(VTK_TRIANGLE, 3), { VTK_QUADRATIC_TRIANGLE, 6 },
         { VTK_BIQUADRATIC_TRIANGLE, 7 }, { VTK_LAGRANGE_TRIANGLE, 7 } })
  {
    kinds.push_back({ type, points, Shape::Prism, none, true });
  }
  for (const auto& [type, points] : { std::pair(VTK_PIXEL, 4), { VTK_QUAD, 4 },
         { VTK_QUADRATIC_LINEAR_QUAD, 6 }, { VTK_QUADRATIC_QUAD, 8 }, { VTK_BIQUADRATIC_QUAD, 9 } })
  {
    kinds.push_back({ type, points, Shape::Hexahedron, none, true });
  }
  kinds.push_back({ VTK_LAGRANGE_QUADRILATERAL, 5 * 3, Shape::Hexahedron, { 4, 2, 0 }, true });
  kinds.push_back({ VTK_BEZIER_QUADRILATERAL, 2 * 4, Shape::Hexahedron, { 1, 3, 1 }, true });
  for (int n = 1; n <= 8; ++n)
  {
    const int line = n + 1;
    const int triangle = line * (n + 2) / 2;
    kinds.push_back({ VTK_LAGRANGE_HEXAHEDRON, line * line * line, Shape::Hexahedron });
    kinds.push_back({ VTK_LAGRANGE_WEDGE, triangle * line, Shape::Prism });
    kinds.push_back({ VTK_LAGRANGE_TETRAHEDRON, triangle * (n + 3) / 3, Shape::Tetrahedron });
    kinds.push_back({ VTK_LAGRANGE_QUADRILATERAL, line * line, Shape::Hexahedron, none, true });
    kinds.push_back({ VTK_LAGRANGE_TRIANGLE, triangle, Shape::Prism, none, true });
    if (n <= 5)
    {
      kinds.push_back({ VTK_BEZIER_QUADRILATERAL, line * line, Shape::Hexahedron, none, true });
      kinds.push_back({ VTK_BEZIER_TRIANGLE, triangle, Shape::Prism, none, true });
      kinds.push_back({ VTK_BEZIER_HEXAHEDRON, line * line * line, Shape::Hexahedron });
      kinds.push_back({ VTK_BEZIER_WEDGE, triangle * line, Shape::Prism });
      kinds.push_back({ VTK_BEZIER_TETRAHEDRON, triangle * (n + 3) / 3, Shape::Tetrahedron });
    }
  }
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(All, CellBasis, ::testing::ValuesIn(Kinds()),
  [](const auto& test)
  {
    return "Type" + std::to_string(test.param.type) + "Points" + std::to_string(test.param.points);
  });
} // namespace
