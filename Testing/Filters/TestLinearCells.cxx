// SPDX-License-Identifier: BSD-3-Clause
// VTK's linear cells beside a solver's elements, right- and left-handed: volumes, faces and values.
#include "Support.h"

#include "Core/Faces/ReferenceFace.h"
#include "Core/Location/Sample.h"
#include "HighOrderModel.h"
#include "vtkHighOrderSubdivide.h"
#include "vtkMFEMReader.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkIntegrateAttributes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct Solid
{
  int geometry; ///< MFEM's number
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces; ///< by vertices
  double volume;
};

std::vector<Solid> Solids()
{
  return {
    { 4, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 3 } },
      { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } }, 0.5 },
    { 5,
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 3 }, { 1, 0, 3 }, { 1, 2, 3 },
        { 0, 2, 3 } },
      { { 3, 2, 1, 0 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
        { 4, 5, 6, 7 } },
      6.0 },
    { 6, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 2 }, { 1, 0, 2 }, { 0, 1, 2 } },
      { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } }, 1.0 },
    { 7, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 3 } },
      { { 3, 2, 1, 0 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } }, 1.0 },
  };
}

double FieldAt(const Vec3& x)
{
  return 1.0 + x.x + 2.0 * x.y + 3.0 * x.z;
}

/// MFEM's files of one element, face f with the attribute f + 1, and of the field.
vtkSmartPointer<vtkUnstructuredGrid> Read(const Solid& solid)
{
  std::ostringstream mesh;
  mesh << "MFEM mesh v1.0\ndimension\n3\nelements\n1\n1 " << solid.geometry;
  for (std::size_t v = 0; v < solid.vertices.size(); ++v)
  {
    mesh << ' ' << v;
  }
  mesh << "\nboundary\n" << solid.faces.size() << '\n';
  for (std::size_t f = 0; f < solid.faces.size(); ++f)
  {
    mesh << f + 1 << (solid.faces[f].size() == 3 ? " 2" : " 3");
    for (const int vertex : solid.faces[f])
    {
      mesh << ' ' << vertex;
    }
    mesh << '\n';
  }
  mesh << "vertices\n" << solid.vertices.size() << "\n3\n";
  std::ostringstream field;
  field << "FiniteElementSpace\nFiniteElementCollection: H1_3D_P1\nVDim: 1\nOrdering: 0\n\n";
  for (const Vec3& x : solid.vertices)
  {
    mesh << x.x << ' ' << x.y << ' ' << x.z << '\n';
    field << FieldAt(x) << '\n';
  }
  const auto folder = std::filesystem::temp_directory_path() /
    ("pixelexact-linear-" + std::to_string(std::random_device()()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.mesh") << mesh.str();
  std::ofstream(folder / "u.gf") << field.str();
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName((folder / "a.mesh").c_str());
  reader->AddGridFunctionFileName((folder / "u.gf").c_str());
  reader->Update();
  std::filesystem::remove_all(folder);
  return reader->GetOutput();
}

Vec3 Mean(const std::vector<Vec3>& places)
{
  Vec3 sum(0.0);
  for (const Vec3& place : places)
  {
    sum += place;
  }
  return sum / static_cast<double>(places.size());
}

Vec3 CentreOf(vtkCell* face)
{
  std::vector<Vec3> places;
  for (vtkIdType k = 0; k < face->GetNumberOfPoints(); ++k)
  {
    const double* const x = face->GetPoints()->GetPoint(k);
    places.emplace_back(x[0], x[1], x[2]);
  }
  return Mean(places);
}

/// Computes the volume as ParaView's Integrate Variables does.
double IntegrateVolume(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkIntegrateAttributes> integrate;
  integrate->SetInputData(grid);
  integrate->Update();
  return integrate->GetOutput()->GetCellData()->GetArray("Volume")->GetComponent(0, 0);
}

void ExpectOutward(vtkCell* cell)
{
  const Vec3 middle = CentreOf(cell);
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
  {
    vtkCell* const face = cell->GetFace(f);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      face->GetPoints()->GetPoint(k, p[k]);
    }
    const Vec3 a(p[0][0], p[0][1], p[0][2]);
    const Vec3 normal =
      glm::cross(Vec3(p[1][0], p[1][1], p[1][2]) - a, Vec3(p[2][0], p[2][1], p[2][2]) - a);
    EXPECT_GT(glm::dot(normal, a - middle), 0.0) << "face " << f;
  }
}

TEST(LinearCells, AreAsVtkWindsThem)
{
  for (const bool mirrored : { false, true })
  {
    for (Solid solid : Solids())
    {
      SCOPED_TRACE(std::to_string(solid.geometry) + (mirrored ? " mirrored" : ""));
      for (Vec3& x : solid.vertices)
      {
        x.x = mirrored ? -x.x : x.x;
      }
      const auto grid = Read(solid);
      ASSERT_EQ(grid->GetNumberOfCells(), 1);
      EXPECT_NEAR(IntegrateVolume(grid), solid.volume, 1e-14);
      ExpectOutward(grid->GetCell(0));
      // Values and attributes are where they belong.
      vtkDataArray* const u = grid->GetPointData()->GetArray("u");
      for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
      {
        const double* const x = grid->GetPoint(p);
        EXPECT_NEAR(u->GetComponent(p, 0), FieldAt({ x[0], x[1], x[2] }), 1e-13);
      }
      vtkDataArray* const attributes = grid->GetCellData()->GetArray("BoundaryAttribute");
      const auto model = HighOrderModel::From(grid);
      const auto boundary = model->BoundaryFaces();
      ASSERT_EQ(boundary.size(), solid.faces.size());
      for (int f = 0; f < static_cast<int>(solid.faces.size()); ++f)
      {
        const auto attribute = static_cast<int>(attributes->GetComponent(0, f));
        ASSERT_GE(attribute, 1);
        std::vector<Vec3> corners;
        for (const int vertex : solid.faces[static_cast<std::size_t>(attribute - 1)])
        {
          corners.push_back(solid.vertices[static_cast<std::size_t>(vertex)]);
        }
        EXPECT_LT(glm::distance(CentreOf(grid->GetCell(0)->GetFace(f)), Mean(corners)), 1e-14);
        const auto own = std::ranges::find(boundary, attribute, &AttributedFace::attribute);
        ASSERT_NE(own, boundary.end());
        const ReferenceFace& face = ReferenceFaceOf(model->GetMesh().ShapeOf(0), own->face.face);
        std::vector<Vec3> places(static_cast<std::size_t>(face.corners));
        MapForward(model->GetMesh(), 0, std::span(face.corner).first(places.size()), places);
        EXPECT_LT(glm::distance(Mean(places), Mean(corners)), 1e-14);
      }
    }
  }
}

TEST(LinearCells, OfSubdividedElementsAreAsVtkWindsThem)
{
  for (const bool mirrored : { false, true })
  {
    for (Solid solid : Solids())
    {
      SCOPED_TRACE(std::to_string(solid.geometry) + (mirrored ? " mirrored" : ""));
      for (Vec3& x : solid.vertices)
      {
        x.x = mirrored ? -x.x : x.x;
      }
      vtkNew<vtkHighOrderSubdivide> subdivide;
      subdivide->SetInputData(Read(solid));
      subdivide->SetLevel(1);
      subdivide->Update();
      auto* const parts = vtkUnstructuredGrid::SafeDownCast(subdivide->GetOutputDataObject(0));
      ASSERT_GT(parts->GetNumberOfCells(), 1);
      EXPECT_NEAR(IntegrateVolume(parts), solid.volume, 1e-14);
      for (vtkIdType cell = 0; cell < parts->GetNumberOfCells(); ++cell)
      {
        ExpectOutward(parts->GetCell(cell));
      }
    }
  }
}

TEST(LinearCells, OfAMeshOfAllShapesArePositive)
{
  vtkNew<vtkMFEMReader> reader;
  const std::string folder = PIXELEXACT_DATA_DIR "/mfem49_tinyzoo_g3_p5/";
  reader->SetFileName((folder + "mfem49_tinyzoo_g3_p5.mesh").c_str());
  reader->Update();
  vtkUnstructuredGrid* const grid = reader->GetOutput();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkUnstructuredGrid> one;
    one->SetPoints(grid->GetPoints());
    one->Allocate(1);
    one->InsertNextCell(grid->GetCellType(cell), grid->GetCell(cell)->GetPointIds());
    EXPECT_GT(IntegrateVolume(one), 0.0) << cell;
  }
}
} // namespace
