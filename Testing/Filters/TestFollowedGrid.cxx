// SPDX-License-Identifier: BSD-3-Clause
// What VTK's filters do to a solver's grid and is followed: motions against the original map,
// changed and new arrays against VTK's own interpolation, and what is refused.
#include "OracleCheck.h"

#include "Core/Location/Locator.h"
#include "Core/Location/Sample.h"
#include "HighOrderModel.h"
#include "vtkHighOrderProbe.h"
#include "vtkMFEMReader.h"
#include "vtkNektarReader.h"

#include "vtkArrayCalculator.h"
#include "vtkClipDataSet.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkWarpScalar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

constexpr const char* kZoo = "mfem49_tinyzoo_g3_p5";

Grid Read(const std::string& name, int cells = vtkHighOrderFileReader::LAGRANGE_CELLS)
{
  const std::string stem = PIXELEXACT_DATA_DIR "/" + name + "/" + name;
  const auto read = [cells](vtkHighOrderFileReader* reader)
  {
    reader->SetCells(cells);
    reader->Update();
    return Grid(vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0)));
  };
  if (name.starts_with("nek"))
  {
    vtkNew<vtkNektarReader> reader;
    reader->SetFileName((stem + ".xml").c_str());
    reader->AddFieldFileName((stem + ".fld").c_str());
    return read(reader);
  }
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName((stem + ".mesh").c_str());
  reader->AddGridFunctionFileName((std::string(PIXELEXACT_DATA_DIR "/") + name + "/u.gf").c_str());
  return read(reader);
}

Grid Moved(vtkUnstructuredGrid* grid, vtkTransform* transform)
{
  vtkNew<vtkTransformFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(grid);
  filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

Grid Calculated(vtkUnstructuredGrid* grid, const std::string& formula, const std::string& result)
{
  vtkNew<vtkArrayCalculator> calculator;
  calculator->SetInputData(grid);
  calculator->AddScalarArrayName("u");
  calculator->SetFunction(formula.c_str());
  calculator->SetResultArrayName(result.c_str());
  calculator->Update();
  return vtkUnstructuredGrid::SafeDownCast(calculator->GetOutput());
}

/// The grid as the converter follows it, which must not fail.
Grid Followed(vtkUnstructuredGrid* grid, const std::string& warning = "")
{
  const Conversion conversion(grid);
  EXPECT_TRUE(conversion.done) << conversion.messages->errors;
  EXPECT_NE(conversion.messages->warnings.find(warning), std::string::npos)
    << conversion.messages->warnings;
  if (warning.empty())
  {
    EXPECT_EQ(conversion.messages->warnings, "");
  }
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(conversion.Output()), "");
  return conversion.Output();
}

void ExpectRefused(vtkUnstructuredGrid* grid, const std::string& word)
{
  const Conversion conversion(grid);
  EXPECT_FALSE(conversion.done);
  EXPECT_NE(conversion.messages->errors.find(word), std::string::npos)
    << conversion.messages->errors << conversion.messages->warnings;
}

/// The largest distance of the followed map from move(x, u) of the original one, and whether the
/// values of u are the same.
double WorstPlace(vtkUnstructuredGrid* original, vtkUnstructuredGrid* followed,
  const std::function<Vec3(const Vec3&, double)>& move)
{
  const auto before = HighOrderModel::From(original);
  const auto after = HighOrderModel::From(followed);
  double worst = 0.0;
  for (int e = 0; e < before->GetMesh().Elements(); ++e)
  {
    const std::vector<Vec3> xi = PlacesIn(before->GetMesh().ShapeOf(e));
    std::vector<Vec3> x(xi.size());
    std::vector<Vec3> y(xi.size());
    std::vector<double> u(xi.size());
    std::vector<double> v(xi.size());
    MapForward(before->GetMesh(), e, xi, x);
    MapForward(after->GetMesh(), e, xi, y);
    EvaluateAt(before->GetMesh(), before->GetField("u"), e, xi, u, {});
    EvaluateAt(after->GetMesh(), after->GetField("u"), e, xi, v, {});
    EXPECT_EQ(u, v);
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      const Vec3 apart = y[k] - move(x[k], u[k]);
      worst = std::max(worst, std::hypot(apart.x, apart.y, apart.z));
    }
  }
  return worst;
}

vtkNew<vtkTransform> Oblique()
{
  vtkNew<vtkTransform> transform;
  transform->Translate(300.0, -20.0, 7.0);
  transform->RotateWXYZ(37.0, 1.0, 2.0, -0.5);
  transform->Scale(2.0, 0.5, 3.0);
  return transform;
}

Vec3 Image(vtkTransform* transform, const Vec3& x)
{
  Vec3 y;
  transform->TransformPoint(&x.x, &y.x);
  return y;
}

TEST(FollowedGrid, AffineMotionsMoveTheCoefficients)
{
  const auto transform = Oblique();
  for (const char* name : { kZoo, "nek_hex_aniso_p3p5p7", "nek_prism_curved_p7",
         "nek_pyramid_curved_p6", "nek_tet_varp" })
  {
    const Grid grid = Read(name);
    const Grid followed = Followed(Moved(grid, transform));
    EXPECT_LE(
      WorstPlace(grid, followed, [&](const Vec3& x, double /*u*/) { return Image(transform, x); }),
      2e-13)
      << name; // some roundings of 300
    const auto model = HighOrderModel::From(followed);
    EXPECT_EQ(model->GetMesh().map.SpaceOf(0), HighOrderModel::From(grid)->GetMesh().map.SpaceOf(0))
      << name;
    // The field's coefficients are shared.
    EXPECT_EQ(followed->GetFieldData()->GetArray("PixelExact.Field.u.Coefficients"),
      grid->GetFieldData()->GetArray("PixelExact.Field.u.Coefficients"))
      << name;
    // A point stays inside its element.
    for (int e = 0; e < model->GetMesh().Elements(); ++e)
    {
      EXPECT_LE(model->GetMesh().uncertainty[static_cast<std::size_t>(e)], 1e-11) << name;
    }
  }
}

TEST(FollowedGrid, LinearCellsOfContinuousFieldsFollowAffineMotions)
{
  const auto transform = Oblique();
  const Grid grid = Read(kZoo, vtkHighOrderFileReader::CORNER_CELLS);
  const Grid followed = Followed(Moved(grid, transform));
  EXPECT_LE(
    WorstPlace(grid, followed, [&](const Vec3& x, double /*u*/) { return Image(transform, x); }),
    2e-13);
}

TEST(FollowedGrid, ThresholdsBeforeAMotionLeaveTheRest)
{
  const auto transform = Oblique();
  vtkNew<vtkExtractCells> part;
  part->SetInputData(Read(kZoo));
  part->AddCellRange(1, 3);
  part->Update();
  const Grid followed = Followed(Moved(part->GetOutput(), transform));
  EXPECT_EQ(followed->GetNumberOfCells(), 3);
  EXPECT_LE(WorstPlace(part->GetOutput(), followed,
              [&](const Vec3& x, double /*u*/) { return Image(transform, x); }),
    2e-13);
}

TEST(FollowedGrid, OtherMotionsOfLagrangeCellsAreTheirPolynomials)
{
  for (const char* name : { "nek_hex_aniso_p3p5p7", "nek_prism_curved_p7", "nek_tet_varp" })
  {
    const Grid grid = Read(name);
    vtkNew<vtkWarpScalar> warp;
    warp->SetInputData(grid);
    warp->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "u");
    warp->UseNormalOn();
    warp->SetNormal(0.0, 0.6, 0.8);
    warp->SetScaleFactor(0.1);
    warp->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    warp->Update();
    const Grid followed = Followed(
      vtkUnstructuredGrid::SafeDownCast(warp->GetOutputDataObject(0)), "the polynomial through");
    EXPECT_LE(WorstPlace(grid, followed,
                [](const Vec3& x, double u) { return x + 0.1 * u * Vec3(0.0, 0.6, 0.8); }),
      1e-12)
      << name;
  }
}

/// The largest difference of a field from the interpolation of the array in VTK's cells, over its
/// range.
double WorstInterpolation(vtkUnstructuredGrid* grid, const std::string& name)
{
  const auto model = HighOrderModel::From(grid);
  vtkDataArray* nodal = grid->GetPointData()->GetArray(name.c_str());
  double range[2];
  nodal->GetRange(range);
  vtkNew<vtkGenericCell> cell;
  double worst = 0.0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    const double at[3] = { 0.2, 0.3, 0.25 };
    double x[3];
    int part = 0;
    cell->EvaluateLocation(part, at, x, weights.data());
    double expected = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k)
    {
      expected += weights[k] * nodal->GetComponent(cell->GetPointId(static_cast<int>(k)), 0);
    }
    const Vec3 point(x[0], x[1], x[2]);
    double value = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values(1);
    SampleTarget target;
    target.value = { &value, 1 };
    SampleTile(model->GetLocator(), &model->GetField(name), std::span(&point, 1), target);
    worst = std::max(worst, std::fabs(value - expected) / (range[1] - range[0]));
    EXPECT_FALSE(std::isnan(value)) << name << " in cell " << c;
  }
  return worst;
}

TEST(FollowedGrid, ChangedAndNewArraysAreInterpolated)
{
  for (const char* name : { "nek_hex_aniso_p3p5p7", "nek_prism_curved_p7", "nek_tet_varp" })
  {
    const Grid grid = Read(name);
    const Grid changed = Followed(Calculated(grid, "sin(3*u)", "u"), "'u' was changed");
    EXPECT_LE(WorstInterpolation(changed, "u"), 1e-12) << name;
    const Grid added = Followed(Calculated(grid, "sin(3*u)", "s"));
    EXPECT_LE(WorstInterpolation(added, "s"), 1e-12) << name;
    // u and the mesh are what they were.
    for (const char* array : { "PixelExact.Field.u.Coefficients", "PixelExact.Mesh.Coefficients" })
    {
      EXPECT_EQ(added->GetFieldData()->GetArray(array), grid->GetFieldData()->GetArray(array));
    }
    const auto transform = Oblique();
    const Grid both = Followed(Moved(Calculated(grid, "sin(3*u)", "u"), transform), "'u'");
    EXPECT_LE(WorstInterpolation(both, "u"), 1e-11) << name;
  }
}

TEST(FollowedGrid, FiltersTakeWhatIsFollowed)
{
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> at;
  at->SetDataTypeToDouble();
  const auto transform = Oblique();
  const Grid grid = Read("nek_prism_curved_p7");
  const Vec3 centre = [&]
  {
    Vec3 x;
    const Vec3 xi =
      TensorToReference(HighOrderModel::From(grid)->GetMesh().ShapeOf(0), Vec3(0.1, -0.2, 0.3));
    MapForward(HighOrderModel::From(grid)->GetMesh(), 0, std::span(&xi, 1), std::span(&x, 1));
    return x;
  }();
  const Vec3 moved = Image(transform, centre);
  at->InsertNextPoint(&moved.x);
  points->SetPoints(at);
  vtkNew<vtkHighOrderProbe> probe;
  vtkNew<Messages> messages;
  messages->Watch(probe);
  probe->SetInputDataObject(0, points);
  probe->SetInputDataObject(1, Moved(Calculated(grid, "2*u + 1", "v"), transform));
  probe->AddField("u");
  probe->AddField("v");
  probe->Update();
  EXPECT_EQ(messages->errors, "");
  vtkPointData* data = vtkPolyData::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
  ASSERT_NE(data->GetArray("u"), nullptr);
  ASSERT_NE(data->GetArray("v"), nullptr);
  EXPECT_NEAR(data->GetArray("v")->GetComponent(0, 0),
    2.0 * data->GetArray("u")->GetComponent(0, 0) + 1.0, 1e-12);
}

TEST(FollowedGrid, PlaneMeshesStayInTheirPlane)
{
  const Grid grid = Read("mfem_plane_amr_g3_p5");
  vtkNew<vtkTransform> turn;
  turn->Translate(1.0, 2.0, 3.0);
  turn->RotateZ(30.0);
  turn->Scale(2.0, 2.0, 2.0);
  const Grid followed = Followed(Moved(grid, turn));
  EXPECT_LE(
    WorstPlace(grid, followed, [&](const Vec3& x, double /*u*/) { return Image(turn, x); }), 1e-14);
  vtkNew<vtkTransform> tilt;
  tilt->RotateX(1.0);
  Followed(Moved(grid, tilt), "out of its plane"); // a solid of nodal values
}

TEST(FollowedGrid, MappedFieldsAreLeftOut)
{
  const std::string path = PIXELEXACT_DATA_DIR "/mfem_plane_amr_g3_p5/";
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName((path + "mfem_plane_amr_g3_p5.mesh").c_str());
  reader->AddGridFunctionFileName((path + "u.gf").c_str());
  reader->AddGridFunctionFileName((path + "flux.gf").c_str());
  reader->Update();
  vtkNew<vtkTransform> turn;
  turn->RotateZ(30.0);
  const Grid followed = Followed(Moved(reader->GetOutput(), turn), "'flux' is left out");
  EXPECT_EQ(HighOrderModel::From(followed)->FindField("flux"), nullptr);
  EXPECT_NE(HighOrderModel::From(followed)->FindField("u"), nullptr);
}

TEST(FollowedGrid, WhatWasCutOrIsTooCoarseIsRefused)
{
  for (const int cells :
    { vtkHighOrderFileReader::LAGRANGE_CELLS, vtkHighOrderFileReader::CORNER_CELLS })
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(0.3, 0.2, 1.0);
    const Grid grid = Read(kZoo, cells);
    plane->SetOrigin(grid->GetCenter());
    vtkNew<vtkClipDataSet> clip;
    clip->SetClipFunction(plane);
    clip->SetInputData(grid);
    clip->Update();
    ExpectRefused(clip->GetOutput(), "(Clip)");
  }
  // Its curved pyramids have linear cells.
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputData(Read(kZoo));
  warp->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "u");
  warp->Update();
  ExpectRefused(vtkUnstructuredGrid::SafeDownCast(warp->GetOutputDataObject(0)), "affine");
  ExpectRefused(
    Calculated(Read(kZoo, vtkHighOrderFileReader::CORNER_CELLS), "2*u", "u"), "was changed");
}
} // namespace
