// SPDX-License-Identifier: BSD-3-Clause
// Rational Bezier cells against VTK's own functions and closed forms.
#include "Core/Location/Sample.h"
#include "HighOrderModel.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pixelexact;

/// A quarter of a ring, between angles `start` and `start` plus 90 degrees and radii 1 and 2, of
/// order 2 along the arc; solid from z = 0 to 1, or plane.
void AddQuarter(vtkUnstructuredGrid* grid, vtkDoubleArray* weights, vtkDoubleArray* field,
  double start, bool isSolid)
{
  const int order[3] = { 2, 1, 1 };
  const int points = isSolid ? 12 : 6;
  std::vector<vtkIdType> ids(static_cast<std::size_t>(points));
  for (int k = 0; k < (isSolid ? 2 : 1); ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int place = isSolid ? vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, order)
                                  : vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, order);
        // The middle control point is the intersection of the ends' tangents.
        const double angle = start + i * std::acos(-1.0) / 4;
        const double radius = (1.0 + j) * (i == 1 ? std::sqrt(2.0) : 1.0);
        const vtkIdType id =
          grid->GetPoints()->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), k);
        ids[static_cast<std::size_t>(place)] = id;
        weights->InsertValue(id, i == 1 ? std::sqrt(0.5) : 1.0);
        field->InsertValue(id, std::sin(3.0 * angle + radius + k));
      }
    }
  }
  grid->InsertNextCell(
    isSolid ? VTK_BEZIER_HEXAHEDRON : VTK_BEZIER_QUADRILATERAL, points, ids.data());
}

vtkSmartPointer<vtkUnstructuredGrid> HalfRing(bool isSolid)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  vtkNew<vtkDoubleArray> field;
  field->SetName("u");
  AddQuarter(grid, weights, field, 0.0, isSolid);
  AddQuarter(grid, weights, field, std::acos(0.0), isSolid);
  grid->GetPointData()->SetRationalWeights(weights);
  grid->GetPointData()->AddArray(field);
  vtkNew<vtkIntArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  const int given[3] = { 2, 1, 1 };
  degrees->InsertNextTypedTuple(given);
  degrees->InsertNextTypedTuple(given);
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
  return grid;
}

struct Errors
{
  double radius = 0.0; ///< of the closed form
  double point = 0.0;  ///< from VTK's functions
  double value = 0.0;
};

Errors Compare(vtkUnstructuredGrid* grid, bool isSolid)
{
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputData(grid);
  convert->Update();
  const auto model = HighOrderModel::From(convert->GetOutput());
  const Mesh& mesh = model->GetMesh();
  const Field& field = *model->FindField("u");
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  Errors errors;
  for (int trial = 0; trial < 400; ++trial)
  {
    const int e = trial % 2;
    double r[3] = { place(random), place(random), isSolid ? place(random) : 0.0 };
    const Vec3 xi(2.0 * r[0] - 1.0, 2.0 * r[1] - 1.0, isSolid ? 2.0 * r[2] - 1.0 : 0.0);
    Vec3 x;
    MapForward(mesh, e, std::span(&xi, 1), std::span(&x, 1));
    std::vector<double> value(1);
    EvaluateAt(mesh, field, e, std::span(&xi, 1), value, {});
    vtkCell* cell = grid->GetCell(e);
    std::vector<double> shares(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    int sub = 0;
    double y[3];
    cell->EvaluateLocation(sub, r, y, shares.data());
    double expected = 0.0;
    for (vtkIdType p = 0; p < cell->GetNumberOfPoints(); ++p)
    {
      expected += shares[static_cast<std::size_t>(p)] *
        grid->GetPointData()->GetArray("u")->GetComponent(cell->GetPointId(p), 0);
    }
    errors.radius = std::max(errors.radius, std::fabs(std::hypot(x.x, x.y) - (1.0 + r[1])));
    errors.point = std::max({ errors.point, std::fabs(x.x - y[0]), std::fabs(x.y - y[1]) });
    errors.value = std::max(errors.value, std::fabs(value[0] - expected));
  }
  return errors;
}

TEST(RationalCells, AreRoundAndAsVtkHasThem)
{
  for (const bool isSolid : { true, false })
  {
    const Errors errors = Compare(HalfRing(isSolid), isSolid);
    EXPECT_LE(errors.radius, 1e-14);
    EXPECT_LE(errors.point, 1e-14);
    EXPECT_LE(errors.value, 2e-14);
  }
}

/// One Bezier cell of order 2 with perturbed control points, random weights and values; or a
/// quarter of a disc (prism: of a cylinder; tetrahedron: of a cone) of radius 1.
vtkSmartPointer<vtkUnstructuredGrid> MakeRationalCell(int type, bool isRound)
{
  const bool isPlane = type == VTK_BEZIER_TRIANGLE;
  const vtkIdType points = isPlane ? 6 : type == VTK_BEZIER_WEDGE ? 18 : 10;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  vtkNew<vtkDoubleArray> field;
  field->SetName("u");
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  // The changes of basis of tetrahedra of high orders take long.
  const double spread = type == VTK_BEZIER_TETRAHEDRON ? 0.02 : 0.1;
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < points; ++i)
  {
    ids.push_back(places->InsertNextPoint(0.0, 0.0, 0.0));
    weights->InsertValue(i, 1.0);
    field->InsertValue(i, unit(random));
  }
  grid->SetPoints(places);
  grid->GetPointData()->SetRationalWeights(weights);
  grid->GetPointData()->AddArray(field);
  grid->InsertNextCell(type, points, ids.data());
  const double* even = grid->GetCell(0)->GetParametricCoords();
  for (vtkIdType i = 0; i < points; ++i)
  {
    double x[3] = { even[3 * i], even[3 * i + 1], even[3 * i + 2] };
    const bool onArc = x[0] == 0.5 && x[1] == 0.5;
    if (isRound && onArc)
    {
      weights->SetValue(i, std::sqrt(0.5));
      x[0] = x[1] = 1.0;
    }
    if (!isRound)
    {
      weights->SetValue(i, 1.0 + spread * unit(random));
      x[0] += 0.1 * unit(random);
      x[1] += 0.1 * unit(random);
      x[2] += isPlane ? 0.0 : 0.1 * unit(random);
    }
    places->SetPoint(i, x);
  }
  return grid;
}

/// Largest differences from VTK's own functions, and of |(x, y)| from 1 on the arc.
Errors CompareOne(int type, bool isRound)
{
  const auto grid = MakeRationalCell(type, isRound);
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputData(grid);
  convert->Update();
  const auto model = HighOrderModel::From(convert->GetOutput());
  const Mesh& mesh = model->GetMesh();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  Errors errors;
  vtkCell* cell = grid->GetCell(0);
  std::vector<double> shares(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  for (int trial = 0; trial < 200; ++trial)
  {
    const bool isOnArc = trial % 2 == 0;
    double r[3] = { place(random), place(random), place(random) };
    r[1] = isOnArc ? 1.0 - r[0] : r[1] * (1.0 - r[0]);
    r[2] = type == VTK_BEZIER_WEDGE ? r[2]
      : type == VTK_BEZIER_TRIANGLE ? 0.0
                                    : r[2] * (1.0 - r[0] - r[1]);
    const Vec3 xi = type == VTK_BEZIER_TETRAHEDRON
      ? Vec3(2 * r[0] - 1, 2 * r[1] - 1, 2 * r[2] - 1)
      : Vec3(2 * r[0] - 1, type == VTK_BEZIER_WEDGE ? 1 - 2 * r[2] : 0.0, 2 * r[1] - 1);
    Vec3 x;
    MapForward(mesh, 0, std::span(&xi, 1), std::span(&x, 1));
    std::vector<double> value(1);
    EvaluateAt(mesh, *model->FindField("u"), 0, std::span(&xi, 1), value, {});
    int sub = 0;
    double y[3];
    cell->EvaluateLocation(sub, r, y, shares.data());
    double expected = 0.0;
    for (vtkIdType p = 0; p < cell->GetNumberOfPoints(); ++p)
    {
      expected += shares[static_cast<std::size_t>(p)] *
        grid->GetPointData()->GetArray("u")->GetComponent(p, 0);
    }
    errors.radius = std::max(errors.radius, isOnArc ? std::fabs(std::hypot(x.x, x.y) - 1.0) : 0.0);
    errors.point = std::max({ errors.point, std::fabs(x.x - y[0]), std::fabs(x.y - y[1]),
      type == VTK_BEZIER_TRIANGLE ? 0.0 : std::fabs(x.z - y[2]) });
    errors.value = std::max(errors.value, std::fabs(value[0] - expected));
  }
  return errors;
}

TEST(RationalCells, TrianglesAndWedges)
{
  for (const int type : { VTK_BEZIER_TRIANGLE, VTK_BEZIER_WEDGE })
  {
    const Errors round = CompareOne(type, true);
    EXPECT_LE(round.radius, 3e-14) << type;
    EXPECT_LE(round.point, 3e-14) << type;
    const Errors random = CompareOne(type, false);
    EXPECT_LE(random.point, 1e-14) << type;
    EXPECT_LE(random.value, 5e-14) << type;
  }
}

TEST(RationalCells, Tetrahedra)
{
  const Errors errors = CompareOne(VTK_BEZIER_TETRAHEDRON, false);
  EXPECT_LE(errors.point, 1e-12);
  EXPECT_LE(errors.value, 4e-12); // of values from -1 to 1
}

TEST(RationalCells, WhatIsLostIsTold)
{
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputData(HalfRing(true));
  convert->Update();
  std::string lines;
  for (int i = 0; i < convert->GetNumberOfDiagnostics(); ++i)
  {
    lines += convert->GetDiagnostic(i) + "\n";
  }
  EXPECT_NE(lines.find("2 cells with rational weights"), std::string::npos) << lines;
  EXPECT_NE(lines.find("field 'u'"), std::string::npos) << lines;
}

/// The mesh is not kept where only weights change.
TEST(RationalCells, OtherWeightsAreAnotherMesh)
{
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  const auto grid = HalfRing(true);
  convert->SetInputData(grid);
  convert->Update();
  auto* weights = vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetRationalWeights());
  weights->FillValue(1.0);
  weights->Modified();
  grid->Modified();
  convert->Update();
  const auto model = HighOrderModel::From(convert->GetOutput());
  const Vec3 xi(0.0, -1.0, 0.0);
  Vec3 x;
  MapForward(model->GetMesh(), 0, std::span(&xi, 1), std::span(&x, 1));
  EXPECT_NEAR(x.x, 0.75, 1e-15); // a parabola
}
} // namespace
