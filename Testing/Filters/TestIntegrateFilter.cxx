// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderIntegrate: against closed forms and VTK's own filters, fields, wrong use.
#include "Support.h"

#include "vtkHighOrderIntegrate.h"
#include "vtkHighOrderSubdivide.h"
#include "vtkImplicitTorus.h"

#include "vtkBox.h"
#include "vtkCellData.h"
#include "vtkCutter.h"
#include "vtkIntegrateAttributes.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"
#include "vtkSuperquadric.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace
{
using namespace pixelexact::testing;

struct Integration
{
  vtkNew<vtkHighOrderIntegrate> filter;
  vtkNew<Messages> messages;

  explicit Integration(vtkUnstructuredGrid* grid, vtkImplicitFunction* function = nullptr)
  {
    messages->Watch(filter);
    filter->SetInputData(grid);
    filter->SetCutFunction(function);
  }
  /// NaN where there is no such row.
  double Get(const char* quantity, const char* column = "Value")
  {
    filter->Update();
    vtkTable* const table = filter->GetOutput();
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      if (table->GetValueByName(row, "Quantity").ToString() == quantity)
      {
        return table->GetValueByName(row, column).ToDouble();
      }
    }
    return std::nan("");
  }
};

TEST(IntegrateFilter, APlaneThroughBoxes)
{
  const auto plane = MakePlaneAt(0.3);
  Integration integration(Boxes(2), plane);
  EXPECT_NEAR(integration.Get("Area"), 1.0, integration.Get("Area", "ErrorBound"));
  EXPECT_LE(integration.Get("Area", "ErrorBound"), 1e-8);
  // x + 2 y + 3 z.
  EXPECT_NEAR(integration.Get("Integral"), 2.4, integration.Get("Integral", "ErrorBound"));
  EXPECT_NEAR(integration.Get("Mean"), 2.4, integration.Get("Mean", "ErrorBound"));
  EXPECT_LE(integration.Get("Mean", "Lower"), 2.4);
  EXPECT_GE(integration.Get("Mean", "Upper"), 2.4);
  EXPECT_TRUE(integration.filter->GetToleranceMet());
  EXPECT_EQ(integration.messages->warnings, "");
  EXPECT_TRUE(std::isnan(integration.Get("Flux")));
}

TEST(IntegrateFilter, APlaneInFacesOfBoxesCountsThemOnce)
{
  const auto plane = MakePlaneAt(0.5);
  Integration integration(Boxes(2), plane);
  EXPECT_NEAR(integration.Get("Area"), 1.0, 1e-8);
  EXPECT_NEAR(integration.Get("Integral"), 3.0, 1e-7);
}

TEST(IntegrateFilter, AQuadricOfOneCoordinateIsItsPlanes)
{
  // (x - 1/2)^2 = d^2, down to two sheets that coincide; then none.
  for (const double square : { 1e-2, 1e-12, 0.0, -1e-12 })
  {
    vtkNew<vtkQuadric> quadric;
    quadric->SetCoefficients(-2.0, 0, 0, 0, 0, 0, 2.0, 0, 0, -0.5 + 2.0 * square);
    Integration integration(Boxes(1), quadric);
    const double sheets = square > 0.0 ? 2.0 : (square == 0.0 ? 1.0 : 0.0);
    EXPECT_NEAR(integration.Get("Area"), sheets, 1e-8) << square;
    EXPECT_NEAR(integration.Get("Integral"), 3.0 * sheets, 1e-7) << square;
    EXPECT_EQ(integration.messages->warnings.empty(), sheets > 0.0)
      << integration.messages->warnings;
  }
}

TEST(IntegrateFilter, AQuadricOfOneDirectionIsItsPlanes)
{
  // (x + y + z - 1)^2 = d^2, and the triangles and hexagons that it cuts from the unit cube.
  for (const double square : { 1e-2, 1e-12, 0.0, -1e-12 })
  {
    vtkNew<vtkQuadric> quadric;
    quadric->SetCoefficients(1, 1, 1, 2, 2, 2, -2, -2, -2, 1.0 - square);
    Integration integration(Boxes(1), quadric);
    const double d = std::sqrt(std::max(square, 0.0));
    const double below = (1.0 - d) * (1.0 - d);
    const double above = (1.0 + d) * (1.0 + d) - 3.0 * d * d;
    const double sheets = square > 0.0 ? below + above : (square == 0.0 ? 1.0 : 0.0);
    EXPECT_NEAR(integration.Get("Area"), sheets * std::sqrt(0.75), 1e-7) << square;
    EXPECT_EQ(integration.messages->warnings.empty(), sheets > 0.0)
      << integration.messages->warnings;
  }
}

TEST(IntegrateFilter, ASphereOfAnyCoefficientsIsNoPlane)
{
  for (const double scale : { 1e-200, 1.0, 1e150 })
  {
    vtkNew<vtkQuadric> quadric;
    quadric->SetCoefficients(scale, scale, scale, 0, 0, 0, 0, 0, 0, -0.5625 * scale);
    Integration integration(Boxes(1), quadric);
    integration.filter->SetTolerance(1e-5);
    EXPECT_NEAR(integration.Get("Area"), std::numbers::pi * 0.75 * 0.75 / 2.0,
      integration.Get("Area", "ErrorBound"))
      << scale;
    EXPECT_LE(integration.Get("Area", "ErrorBound"), 1e-4) << scale;
  }
}

TEST(IntegrateFilter, ASphereAndTheBoundary)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(0.0, 0.0, 0.0);
  sphere->SetRadius(0.75);
  Integration integration(Boxes(1), sphere);
  integration.filter->SetTolerance(1e-5);
  EXPECT_NEAR(integration.Get("Area"), std::numbers::pi * 0.75 * 0.75 / 2.0,
    integration.Get("Area", "ErrorBound"));
  EXPECT_LE(integration.Get("Area", "ErrorBound"), 1e-4);

  Integration boundary(Boxes(2));
  EXPECT_NEAR(boundary.Get("Area"), 6.0, 1e-7);
  // The mean of x + 2 y + 3 z over the unit cube's faces.
  EXPECT_NEAR(boundary.Get("Mean"), 3.0, 1e-7);
}

TEST(IntegrateFilter, VtksFiltersConvergeToIt)
{
  const auto grid = ReadGrid(std::filesystem::path(PIXELEXACT_DATA_DIR) / "toroid_hex_g3_p6.vtu");
  const auto plane = MakePlaneAt(0.1);
  Integration integration(grid, plane);
  integration.filter->SetFieldName("u");
  integration.filter->SetTolerance(1e-4);
  const double exact = integration.Get("Area");
  double before = 0.0;
  for (const int level : { 1, 2, 3 })
  {
    vtkNew<vtkHighOrderSubdivide> subdivide;
    subdivide->SetInputData(Converted(grid));
    subdivide->SetLevel(level);
    vtkNew<vtkCutter> cutter;
    cutter->SetInputConnection(subdivide->GetOutputPort());
    cutter->SetCutFunction(plane);
    vtkNew<vtkIntegrateAttributes> integrate;
    integrate->SetInputConnection(cutter->GetOutputPort());
    integrate->Update();
    auto* sums = vtkUnstructuredGrid::SafeDownCast(integrate->GetOutputDataObject(0));
    const double error = std::fabs(sums->GetCellData()->GetArray("Area")->GetTuple1(0) - exact);
    if (level > 1)
    {
      // The convergence is of second order.
      EXPECT_LT(error, 0.35 * before) << "level " << level;
    }
    before = error;
  }
  EXPECT_LT(before, 3e-3);
}

TEST(IntegrateFilter, BoxesToriAndDiscs)
{
  vtkNew<vtkBox> box;
  box->SetBounds(0.25, 0.75, 0.125, 0.5, 0.5, 0.875);
  Integration faces(Boxes(2), box);
  const double area = 2.0 * (0.5 * 0.375 + 0.375 * 0.375 + 0.5 * 0.375);
  EXPECT_NEAR(faces.Get("Area"), area, faces.Get("Area", "ErrorBound"));
  EXPECT_LE(faces.Get("Area", "ErrorBound"), 1e-7);
  // The mean of x + 2 y + 3 z is that in the box's middle.
  EXPECT_NEAR(faces.Get("Mean"), 0.5 + 0.625 + 3.0 * 0.6875, 1e-6);

  const auto plane = MakePlaneAt(0.3);
  vtkNew<vtkSphere> ball;
  ball->SetCenter(0.5, 0.5, 0.3);
  ball->SetRadius(0.25);
  Integration disc(Boxes(2), plane);
  disc.filter->AddClipFunction(ball);
  disc.filter->SetTolerance(1e-6);
  EXPECT_NEAR(disc.Get("Area"), std::numbers::pi / 16.0, disc.Get("Area", "ErrorBound"));
  EXPECT_LE(disc.Get("Area", "ErrorBound"), 1e-6);
  EXPECT_NEAR(disc.Get("Mean"), 0.5 + 1.0 + 0.9, 1e-4);
  disc.filter->ClearClipFunctions();
  EXPECT_NEAR(disc.Get("Area"), 1.0, 1e-5);

  vtkNew<vtkImplicitTorus> torus;
  torus->SetCenter(0.5, 0.5, 0.5);
  torus->SetRadius(0.3);
  torus->SetTubeRadius(0.1);
  Integration ring(Boxes(1), torus);
  ring.filter->SetTolerance(2e-2);
  const double ofTorus = 4.0 * std::numbers::pi * std::numbers::pi * 0.03;
  EXPECT_NEAR(ring.Get("Area"), ofTorus, ring.Get("Area", "ErrorBound"));

  // The same by a transform.
  vtkNew<vtkTransform> toTorus;
  toTorus->Scale(2.0, 2.0, 2.0);
  toTorus->Translate(-0.5, -0.5, -0.5);
  torus->SetCenter(0.0, 0.0, 0.0);
  torus->SetRadius(0.6);
  torus->SetTubeRadius(0.2);
  torus->SetTransform(toTorus);
  EXPECT_NEAR(ring.Get("Area"), ofTorus, ring.Get("Area", "ErrorBound"));
}

TEST(IntegrateFilter, AnIsoSurface)
{
  // x + 2 y + 3 z = 3 through the middle of the unit cube, in which 3 z = 3 - x - 2 y is for all
  // (x, y).
  Integration iso(Boxes(2));
  iso.filter->SetOver(vtkHighOrderIntegrate::OverIsoSurface);
  iso.filter->SetIsoValue(3.0);
  EXPECT_NEAR(iso.Get("Area"), std::sqrt(14.0) / 3.0, iso.Get("Area", "ErrorBound"));
  EXPECT_NEAR(iso.Get("Mean"), 3.0, 1e-6);
  EXPECT_EQ(iso.messages->errors, "");
  iso.filter->SetOver(vtkHighOrderIntegrate::OverBoundary);
  EXPECT_NEAR(iso.Get("Area"), 6.0, 1e-6);
  iso.filter->SetOver(vtkHighOrderIntegrate::OverCutFunction);
  iso.filter->Update();
  EXPECT_NE(iso.messages->errors.find("SetCutFunction"), std::string::npos);
}

TEST(IntegrateFilter, WrongUseIsRefused)
{
  const auto clipped = MakePlaneAt(0.5);
  vtkNew<vtkSuperquadric> wrongClip;
  Integration clip(Boxes(1), clipped);
  clip.filter->AddClipFunction(wrongClip);
  clip.filter->Update();
  EXPECT_NE(clip.messages->errors.find("clipped by planes"), std::string::npos);

  vtkNew<vtkSuperquadric> function;
  Integration unknown(Boxes(1), function);
  unknown.filter->Update();
  EXPECT_NE(unknown.messages->errors.find("vtkSuperquadric"), std::string::npos);
  EXPECT_NE(unknown.messages->errors.find("spheres"), std::string::npos);

  const auto plane = MakePlaneAt(0.5);
  Integration named(Boxes(1), plane);
  named.filter->SetFieldName("q");
  named.filter->Update();
  EXPECT_NE(named.messages->errors.find("'q'"), std::string::npos);

  Integration both(Boxes(1), plane);
  both.filter->AddBoundaryAttribute(1);
  both.filter->Update();
  EXPECT_NE(both.messages->errors.find("one of them"), std::string::npos);

  Integration tolerance(Boxes(1), plane);
  tolerance.filter->SetTolerance(-1.0);
  tolerance.filter->Update();
  EXPECT_NE(tolerance.messages->errors.find("greater than 0"), std::string::npos);
}
} // namespace
