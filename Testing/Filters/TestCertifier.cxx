// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderCertifier on manufactured cells, and its verdicts against dense sampling on real
// ones.
#include "LoadMesh.h"
#include "Support.h"

#include "Core/Element/Transform.h"
#include "Core/Math/Mat.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkHighOrderCertifier.h"

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

vtkSmartPointer<vtkUnstructuredGrid> Certified(vtkUnstructuredGrid* grid, const std::string& field)
{
  vtkNew<vtkHighOrderCertifier> certifier;
  certifier->SetInputData(grid);
  certifier->SetFieldName(field);
  certifier->Update();
  return vtkUnstructuredGrid::SafeDownCast(certifier->GetOutputDataObject(0));
}

double CellValue(vtkUnstructuredGrid* grid, const char* name, vtkIdType cell, int component = 0)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  return array ? array->GetComponent(cell, component) : std::nan("");
}

/// The least det J of an element's map, in its own units, on an equispaced grid in eta with the
/// element's vertices but not a pyramid's apex.
double LeastSample(const Mesh& mesh, int element, int n)
{
  std::array<std::vector<double>, 3> xi;
  const bool pyramid = mesh.ShapeOf(element) == Shape::Pyramid;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; k < (pyramid ? n : n + 1); ++k)
      {
        const Vec3 point = TensorToReference(
          mesh.ShapeOf(element), { 2.0 * i / n - 1.0, 2.0 * j / n - 1.0, 2.0 * k / n - 1.0 });
        for (int d = 0; d < 3; ++d)
        {
          xi[d].push_back(point[d]);
        }
      }
    }
  }
  const int count = static_cast<int>(xi[0].size());
  for (auto& x : xi)
  {
    x.resize(PaddedCount(count), x.back());
  }
  double least = 1e300;
  for (const Mat3& J :
    Jacobians(mesh, element, { { xi[0].data(), xi[1].data(), xi[2].data() }, count }))
  {
    least = std::min(least, glm::determinant(J));
  }
  return least;
}

TEST(Certifier, PlainGridsAreConverted)
{
  const auto output = Certified(Boxes(2), "f");
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfCells(), 8);
  for (vtkIdType cell = 0; cell < 8; ++cell)
  {
    EXPECT_EQ(CellValue(output, "Verdict", cell), 0.0);
    // The map from [-1,1]^3 to cubes of side 1/2 has the determinant 1/64.
    EXPECT_LE(CellValue(output, "JacobianLower", cell), 1.0 / 64);
    EXPECT_GE(CellValue(output, "JacobianUpper", cell), 1.0 / 64);
    EXPECT_NEAR(CellValue(output, "JacobianLower", cell), 1.0 / 64, 1e-13);
    EXPECT_NEAR(CellValue(output, "JacobianUpper", cell), 1.0 / 64, 1e-13);
    // f = x + 2 y + 3 z.
    const double least =
      0.5 * (double(cell % 2) + 2.0 * double(cell / 2 % 2) + 3.0 * double(cell / 4));
    EXPECT_LE(CellValue(output, "f_lower", cell), least);
    EXPECT_GE(CellValue(output, "f_upper", cell), least + 3.0);
    EXPECT_NEAR(CellValue(output, "f_lower", cell), least, 1e-12);
    EXPECT_NEAR(CellValue(output, "f_upper", cell), least + 3.0, 1e-12);
  }
  EXPECT_NE(output->GetPointData()->GetArray("f"), nullptr);
}

TEST(Certifier, InvertedFoldedAndFlatCells)
{
  const std::vector<double> corners{ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1,
    0, 1, 1 };
  auto pushed = corners;
  pushed[18] = pushed[19] = pushed[20] = 0.3; // beyond the plane of its neighbours' edges
  auto mirrored = corners;
  auto flat = corners;
  for (std::size_t i = 2; i < corners.size(); i += 3)
  {
    mirrored[i] = -corners[i];
    flat[i] = 0.0;
  }
  EXPECT_EQ(CellValue(Certified(OneCell(VTK_HEXAHEDRON, corners), ""), "Verdict", 0), 0.0);
  EXPECT_EQ(CellValue(Certified(OneCell(VTK_HEXAHEDRON, pushed), ""), "Verdict", 0), 1.0);
  EXPECT_EQ(CellValue(Certified(OneCell(VTK_HEXAHEDRON, mirrored), ""), "Verdict", 0), 1.0);
  EXPECT_NE(CellValue(Certified(OneCell(VTK_HEXAHEDRON, flat), ""), "Verdict", 0), 0.0);
}

TEST(Certifier, CellsOfLowerDimensionHaveNoVerdict)
{
  const auto grid = Boxes(1);
  const vtkIdType ids[4] = { 0, 1, 3, 2 };
  grid->InsertNextCell(VTK_QUAD, 4, ids);
  const auto output = Certified(grid, "f");
  ASSERT_EQ(output->GetNumberOfCells(), 2);
  EXPECT_EQ(CellValue(output, "Verdict", 0), 0.0);
  EXPECT_EQ(CellValue(output, "Verdict", 1), 255.0);
  EXPECT_TRUE(std::isnan(CellValue(output, "JacobianLower", 1)));
  EXPECT_TRUE(std::isnan(CellValue(output, "f_upper", 1)));
}

TEST(Certifier, KeepsCoefficientsAndTheirType)
{
  const auto output = Certified(Converted(Boxes(2)), "f");
  EXPECT_NE(vtkHighOrderGrid::SafeDownCast(output), nullptr);
  // The output is still a high-order grid.
  EXPECT_EQ(HighOrderModel::From(output)->GetMesh().Elements(), 8);
}

TEST(Certifier, RefusesAFieldThatIsNotThere)
{
  vtkNew<vtkHighOrderCertifier> certifier;
  vtkNew<Messages> messages;
  messages->Watch(certifier);
  certifier->SetInputData(Boxes(1));
  certifier->SetFieldName("g");
  certifier->Update();
  EXPECT_NE(messages->errors.find("'g'"), std::string::npos) << messages->errors;
}

TEST(Certifier, NotFiniteIsNotANumber)
{
  const auto grid = Boxes(2);
  grid->GetPointData()->GetArray("f")->SetComponent(0, 0, std::nan(""));
  const auto output = Certified(grid, "f");
  EXPECT_TRUE(std::isnan(CellValue(output, "f_lower", 0)));
  EXPECT_EQ(CellValue(output, "Verdict", 0), 0.0);
  EXPECT_FALSE(std::isnan(CellValue(output, "f_lower", 7)));
}

/// Every verdict on a mesh against samples.
void CompareWithSamples(const std::filesystem::path& file, int inverted)
{
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << file << " is not there";
  }
  const auto grid = LoadMesh(file);
  ASSERT_NE(grid, nullptr);
  const auto output = Certified(grid, "");
  const auto model = HighOrderModel::From(grid);
  int found = 0;
  for (int e = 0; e < model->GetMesh().Elements(); ++e)
  {
    const double verdict = CellValue(output, "Verdict", e);
    const double sample = LeastSample(model->GetMesh(), e, 6);
    if (verdict == 0.0)
    {
      EXPECT_GT(sample, 0.0) << file << " element " << e;
      continue;
    }
    EXPECT_EQ(verdict, 1.0) << file << " element " << e;
    ++found;
    // Somewhere it is not positive, if only by rounding.
    EXPECT_LE(std::min(sample, LeastSample(model->GetMesh(), e, 40)), 1e-4)
      << file << " element " << e;
  }
  EXPECT_EQ(found, inverted);
}

TEST(Certifier, SamplesAgreeOnRealMeshes)
{
  CompareWithSamples(kData / "escher_tet_g3_p3.vtu", 0);
  CompareWithSamples(kData / "fichera_hex_g3_p4.vtu", 0);
  CompareWithSamples(kData / "toroid_prism_g3_p4.vtu", 0);
}

TEST(Certifier, SamplesAgreeOnAMeshWithInvertedElements)
{
  CompareWithSamples(std::filesystem::path(PIXELEXACT_SHARED_DATA_DIR) / "glvis_mesh_explorer_g4" /
      "glvis_mesh_explorer_g4.mesh",
    98);
}
} // namespace
