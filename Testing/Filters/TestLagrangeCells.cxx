// SPDX-License-Identifier: BSD-3-Clause
// VTK's Lagrange cells beside a solver's elements: VTK's own interpolation in them gives the
// polynomials of the coefficients.
#include "Support.h"

#include "Core/Faces/ReferenceFace.h"
#include "Core/Location/Sample.h"
#include "HighOrderModel.h"
#include "vtkMFEMReader.h"
#include "vtkNektarReader.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkTetra.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

vtkSmartPointer<vtkHighOrderFileReader> ReaderOf(const std::string& name)
{
  const std::string stem = PIXELEXACT_DATA_DIR "/" + name + "/" + name;
  if (name.starts_with("nek"))
  {
    const auto reader = vtkSmartPointer<vtkNektarReader>::New();
    reader->SetFileName((stem + ".xml").c_str());
    reader->AddFieldFileName((stem + ".fld").c_str());
    return reader;
  }
  const auto reader = vtkSmartPointer<vtkMFEMReader>::New();
  reader->SetFileName((stem + ".mesh").c_str());
  reader->AddGridFunctionFileName((std::string(PIXELEXACT_DATA_DIR "/") + name + "/u.gf").c_str());
  return reader;
}

/// The largest difference of the interpolation of `u` in VTK's cells from the field at the same
/// place of the element, over the field's largest value.
double WorstInterpolation(vtkUnstructuredGrid* grid)
{
  const auto model = HighOrderModel::From(grid);
  const Field& field = model->GetField("u");
  vtkDataArray* const nodal = grid->GetPointData()->GetArray("u");
  std::mt19937 random(5);
  std::uniform_real_distribution<double> inside(0.05, 0.3); // also in r + s + t <= 1
  double worst = 0.0;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType e = 0; e < grid->GetNumberOfCells(); ++e)
  {
    grid->GetCell(e, cell);
    const auto count = static_cast<std::size_t>(cell->GetNumberOfPoints());
    std::vector<double> weights(count);
    const double at[3] = { inside(random), inside(random), inside(random) };
    int part = 0;
    double x[3];
    cell->EvaluateLocation(part, at, x, weights.data());
    double value = 0.0;
    for (std::size_t k = 0; k < count; ++k)
    {
      value += weights[k] * nodal->GetComponent(cell->GetPointId(static_cast<int>(k)), 0);
    }
    const Vec3 place(x[0], x[1], x[2]);
    double exact = std::numeric_limits<double>::quiet_NaN();
    std::int32_t element = -1;
    SampleTarget target;
    target.value = { &exact, 1 };
    target.element = { &element, 1 };
    SampleTile(model->GetLocator(), &field, std::span(&place, 1), target);
    EXPECT_EQ(element, e);
    worst = std::max(worst, std::fabs(exact - value));
  }
  double range[2];
  nodal->GetRange(range);
  return worst / std::max(std::fabs(range[0]), std::fabs(range[1]));
}

TEST(LagrangeCells, InterpolateTheFieldsThemselves)
{
  for (const char* name :
    { "nek_hex_aniso_p3p5p7", "nek_hex_gll_lagrange_p6", "nek_prism_curved_p7", "nek_tet_varp" })
  {
    SCOPED_TRACE(name);
    const auto reader = ReaderOf(name);
    reader->Update();
    EXPECT_LT(WorstInterpolation(reader->GetOutput()), 1e-13);
  }
}

/// The volume, signed, of the tetrahedra into which VTK cuts a cell.
double VolumeOfTetrahedra(vtkCell* cell)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> corners;
  cell->Triangulate(0, ids, corners);
  double sum = 0.0;
  for (vtkIdType k = 0; k + 3 < corners->GetNumberOfPoints(); k += 4)
  {
    double p[4][3];
    for (vtkIdType c = 0; c < 4; ++c)
    {
      corners->GetPoint(k + c, p[c]);
    }
    sum += vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]);
  }
  return sum;
}

TEST(LagrangeCells, HavePositiveVolumesAndTheFacesOfTheirAttributes)
{
  for (const char* name :
    { "nek_hex_gll_lagrange_p6", "nek_prism_curved_p7", "nek_tet_varp", "mfem49_tinyzoo_g3_p5" })
  {
    SCOPED_TRACE(name);
    const auto reader = ReaderOf(name);
    reader->Update();
    vtkUnstructuredGrid* const grid = reader->GetOutput();
    for (vtkIdType e = 0; e < grid->GetNumberOfCells(); ++e)
    {
      EXPECT_GT(VolumeOfTetrahedra(grid->GetCell(e)), 0.0) << e;
    }

    const auto model = HighOrderModel::From(grid);
    vtkDataArray* const attributes = grid->GetCellData()->GetArray("BoundaryAttribute");
    ASSERT_NE(attributes, nullptr);
    for (const AttributedFace& own : model->BoundaryFaces())
    {
      const int e = own.face.element;
      const ReferenceFace& face = ReferenceFaceOf(model->GetMesh().ShapeOf(e), own.face.face);
      std::vector<Vec3> corners(static_cast<std::size_t>(face.corners));
      MapForward(model->GetMesh(), e, std::span(face.corner).first(corners.size()), corners);
      // The face of the cell that has all these corners carries the attribute.
      int found = -1;
      for (int f = 0; f < grid->GetCell(e)->GetNumberOfFaces(); ++f)
      {
        vtkCell* const other = grid->GetCell(e)->GetFace(f);
        const auto has = [other](const Vec3& corner)
        {
          for (vtkIdType k = 0; k < other->GetNumberOfPoints(); ++k)
          {
            double x[3];
            other->GetPoints()->GetPoint(k, x);
            if (glm::distance(corner, Vec3(x[0], x[1], x[2])) < 1e-10)
            {
              return true;
            }
          }
          return false;
        };
        found = std::ranges::all_of(corners, has) ? f : found;
      }
      ASSERT_GE(found, 0) << e;
      EXPECT_EQ(attributes->GetComponent(e, found), own.attribute) << e;
    }
  }
}

TEST(LagrangeCells, SharePointsWhereFieldsAreContinuous)
{
  const std::string folder = PIXELEXACT_DATA_DIR "/mfem_beam_hex_elast_p4/";
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName((folder + "mfem_beam_hex_elast_p4.mesh").c_str());
  reader->AddGridFunctionFileName((folder + "displacement.gf").c_str());
  reader->Update();
  vtkUnstructuredGrid* const grid = reader->GetOutput();
  EXPECT_EQ(grid->GetCellType(0), VTK_LAGRANGE_HEXAHEDRON);
  EXPECT_EQ(grid->GetCell(0)->GetNumberOfPoints(), 5 * 5 * 5);
  EXPECT_EQ(grid->GetNumberOfPoints(), 65 * 9 * 9); // 16 x 2 x 2 elements of order 4
  EXPECT_EQ(grid->GetCellData()->GetArray("PixelExactLinearizedOrder"), nullptr);

  const auto jumping = ReaderOf("nek_prism_curved_p7");
  jumping->Update();
  EXPECT_EQ(jumping->GetOutput()->GetNumberOfPoints(), 3 * 36 * 8); // 3 wedges of order 7
}

TEST(LagrangeCells, GiveWayToCornersOnRequestAndAboveALimit)
{
  const auto reader = ReaderOf("nek_hex_gll_lagrange_p6");
  reader->SetCells(vtkHighOrderFileReader::CORNER_CELLS);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_EQ(reader->GetNumberOfDiagnostics(), 0);
  reader->SetCells(vtkHighOrderFileReader::LAGRANGE_CELLS);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetCellType(0), VTK_LAGRANGE_HEXAHEDRON);
  reader->SetMaximumNumberOfNodes(1000);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetCellType(0), VTK_HEXAHEDRON);
  ASSERT_EQ(reader->GetNumberOfDiagnostics(), 1);
  EXPECT_NE(std::string(reader->GetDiagnostic(0)).find("2744 nodes"), std::string::npos)
    << reader->GetDiagnostic(0);
}
} // namespace
