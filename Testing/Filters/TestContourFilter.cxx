// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderContour: against probing, against VTK's contours of a triangulated cut, wrong use.
#include "Support.h"

#include "ContourList.h"
#include "Core/Contour/RoundValues.h"
#include "vtkHighOrderContour.h"
#include "vtkHighOrderProbe.h"
#include "vtkMFEMReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCone.h"
#include "vtkContourFilter.h"
#include "vtkCylinder.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"
#include "vtkSuperquadric.h"
#include "vtkTransform.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

namespace
{
using namespace pixelexact::testing;

struct Contouring
{
  vtkNew<vtkHighOrderContour> filter;
  vtkNew<Messages> messages;

  Contouring(vtkUnstructuredGrid* grid, vtkImplicitFunction* function)
  {
    messages->Watch(filter);
    filter->SetInputData(grid);
    filter->SetCutFunction(function);
  }
  vtkPolyData* Output()
  {
    filter->Update();
    return filter->GetOutput();
  }
};

double LengthOf(vtkPolyData* lines)
{
  double length = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    lines->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      double a[3];
      double b[3];
      lines->GetPoint(ids->GetId(i), a);
      lines->GetPoint(ids->GetId(i + 1), b);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    }
  }
  return length;
}

/// The distance of a point from the chords of the lines.
double Distance(const double* x, vtkPolyData* lines)
{
  double nearest = std::numeric_limits<double>::infinity();
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    lines->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      double a[3];
      double b[3];
      lines->GetPoint(ids->GetId(i), a);
      lines->GetPoint(ids->GetId(i + 1), b);
      double along = 0.0;
      double square = 0.0;
      for (int d = 0; d < 3; ++d)
      {
        along += (x[d] - a[d]) * (b[d] - a[d]);
        square += (b[d] - a[d]) * (b[d] - a[d]);
      }
      const double t = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
      double distance = 0.0;
      for (int d = 0; d < 3; ++d)
      {
        const double away = x[d] - a[d] - t * (b[d] - a[d]);
        distance += away * away;
      }
      nearest = std::min(nearest, std::sqrt(distance));
    }
  }
  return nearest;
}

TEST(RoundValues, AreWhatAReaderOfAScaleExpects)
{
  using pixelexact::RoundValues;
  using Values = std::vector<double>;
  EXPECT_EQ(RoundValues(9, { 0.0, 1.0 }), (Values{ 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9 }));
  EXPECT_EQ(RoundValues(1, { 0.0, 1.0 }), (Values{ 0.5 }));
  EXPECT_EQ(RoundValues(3, { 0.0, 1.0 }), (Values{ 0.25, 0.5, 0.75 }));
  EXPECT_EQ(RoundValues(5, { 0.0, 1.0 }), (Values{ 0.1, 0.3, 0.5, 0.7, 0.9 }));
  EXPECT_EQ(RoundValues(9, { -0.845, 0.8451 }),
    (Values{ -0.8, -0.6, -0.4, -0.2, 0.0, 0.2, 0.4, 0.6, 0.8 }));
  // Ends that a proof has moved out by a little are ends.
  EXPECT_EQ(
    RoundValues(9, { -3e-4, 1.0004 }), (Values{ 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9 }));
  EXPECT_EQ(RoundValues(1, { 0.01, 1.0 }, true), (Values{ 0.1 }));
  EXPECT_EQ(RoundValues(5, { 1e-3, 1e3 }, true), (Values{ 0.01, 0.1, 1.0, 10.0, 100.0 }));
}

TEST(RoundValues, AreSoManyStrictlyInsideEquallySpacedAndRound)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  std::uniform_real_distribution<double> power(-12.0, 12.0);
  for (int turn = 0; turn < 3000; ++turn)
  {
    const int count = 1 + static_cast<int>(random() % 40);
    double lower = part(random) * std::pow(10.0, power(random));
    double upper = part(random) * std::pow(10.0, power(random));
    if (lower > upper)
    {
      std::swap(lower, upper);
    }
    const std::vector<double> values = pixelexact::RoundValues(count, { lower, upper });
    ASSERT_EQ(values.size(), static_cast<std::size_t>(count)) << lower << " " << upper;
    ASSERT_GT(values.front(), lower);
    ASSERT_LT(values.back(), upper);
    const double length = upper - lower;
    const double step = count > 1 ? values[1] - values[0] : length;
    // There is no room for a further value.
    EXPECT_LE(values.front() - lower, 1.06 * step);
    EXPECT_LE(upper - values.back(), 1.06 * step);
    // Multiples of a hundredth of the power of ten below the range's part for one.
    const double unit = std::pow(10.0, std::floor(std::log10(length / count)) - 2.0);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      EXPECT_NEAR(values[i], values.front() + static_cast<double>(i) * step, 1e-9 * length);
      if (std::fabs(values[i] / unit) < 1e9)
      {
        EXPECT_NEAR(values[i] / unit, std::round(values[i] / unit), 1e-5);
      }
    }
    const double least = std::pow(10.0, power(random));
    const std::array range{ least, least * std::pow(10.0, 0.1 + 0.5 * std::fabs(power(random))) };
    const std::vector<double> powers = pixelexact::RoundValues(count, range, true);
    ASSERT_EQ(powers.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(std::ranges::is_sorted(powers, std::less_equal()));
    EXPECT_GT(powers.front(), range[0]);
    EXPECT_LT(powers.back(), range[1]);
  }
}

TEST(RoundValues, ThereAreNoneInWhatIsNoRange)
{
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::array<double, 2> range : { std::array{ 1.0, 1.0 }, std::array{ 2.0, 1.0 },
         std::array{ 0.0, inf }, std::array{ nan, 1.0 }, std::array{ 1.0, 1.0 + 1e-15 } })
  {
    EXPECT_TRUE(pixelexact::RoundValues(3, range).empty());
    EXPECT_TRUE(pixelexact::RoundValues(3, { range[0] - 3.0, range[1] - 3.0 }, true).empty());
  }
  EXPECT_TRUE(pixelexact::RoundValues(0, { 0.0, 1.0 }).empty());
  EXPECT_TRUE(pixelexact::RoundValues(3, { 0.0, 1.0 }, true).empty());
}

TEST(ContourFilter, StraightLinesHaveTheirLengths)
{
  const auto grid = Boxes(2); // f = x + 2 y + 3 z
  const auto plane = MakePlaneAt(0.3);
  Contouring contours(grid, plane);
  contours.filter->SetFieldName("f");
  contours.filter->GenerateValues(3, 1.2, 2.4); // x + 2 y = 0.3, 0.9, 1.5
  vtkPolyData* lines = contours.Output();
  EXPECT_EQ(contours.messages->errors + contours.messages->warnings, "");
  ASSERT_EQ(lines->GetNumberOfCells(), 3);
  EXPECT_EQ(contours.filter->GetNumberOfUncertifiedLines(), 0);
  // The lines go from (0.3, 0) to (0, 0.15), from (0.9, 0) to (0, 0.45), and from (1, 0.25) to (0,
  // 0.75).
  const double expected = std::hypot(0.3, 0.15) + std::hypot(0.9, 0.45) + std::hypot(1.0, 0.5);
  EXPECT_NEAR(LengthOf(lines), expected, 1e-14);
  auto* certified = lines->GetCellData()->GetArray("Certified");
  auto* value = lines->GetCellData()->GetArray("ContourValue");
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(certified->GetTuple1(i), 1.0);
    EXPECT_DOUBLE_EQ(value->GetTuple1(i), 1.2 + 0.6 * static_cast<double>(i));
    EXPECT_EQ(lines->GetCellData()->GetArray("Closed")->GetTuple1(i), 0.0);
  }
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double gradient[3];
    lines->GetPointData()->GetArray("Gradient")->GetTuple(i, gradient);
    EXPECT_NEAR(gradient[0], 1.0, 1e-13);
    EXPECT_NEAR(gradient[1], 2.0, 1e-13);
    EXPECT_NEAR(gradient[2], 3.0, 1e-13);
  }
}

TEST(ContourFilter, RefusesAFieldOfTheNameOfItsOwnArrays)
{
  const auto grid = Boxes(2);
  grid->GetPointData()->GetArray("f")->SetName("Xi");
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.5, 0.3);
  vtkNew<vtkHighOrderContour> contour;
  vtkNew<Messages> messages;
  messages->Watch(contour);
  contour->SetInputData(grid);
  contour->SetCutFunction(plane);
  contour->SetValue(0, 2.0);
  contour->Update();
  EXPECT_NE(messages->errors.find("'Xi'"), std::string::npos) << messages->errors;
}

TEST(ContourFilter, PointsHaveTheValueThatProbingFinds)
{
  const auto grid = Converted(ReadGrid(kToroid));
  const auto plane = MakePlaneAt(0.02);
  Contouring contours(grid, plane);
  contours.filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "u");
  contours.filter->SetValue(0, 0.02);
  vtkPolyData* lines = contours.Output();
  ASSERT_GT(lines->GetNumberOfCells(), 0);
  EXPECT_EQ(contours.filter->GetNumberOfUncertifiedLines(), 0);
  EXPECT_EQ(contours.messages->warnings, "");
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(lines);
  probe->SetSourceData(grid);
  probe->ComputeGradientsOn();
  probe->Update();
  auto* found = probe->GetPolyDataOutput()->GetPointData();
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(lines->GetPoint(i)[2], 0.02, 1e-16);
    EXPECT_NEAR(lines->GetPointData()->GetArray("u")->GetTuple1(i), 0.02, 1e-15);
    EXPECT_EQ(found->GetArray("Verdict")->GetTuple1(i), 1.0);
    EXPECT_NEAR(found->GetArray("u")->GetTuple1(i), 0.02, 1e-13);
    if (found->GetArray("Element")->GetTuple1(i) ==
      lines->GetPointData()->GetArray("Element")->GetTuple1(i))
    {
      for (int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(found->GetArray("u_Gradient")->GetComponent(i, d),
          lines->GetPointData()->GetArray("Gradient")->GetComponent(i, d), 1e-10);
        EXPECT_NEAR(found->GetArray("Xi")->GetComponent(i, d),
          lines->GetPointData()->GetArray("Xi")->GetComponent(i, d), 1e-12);
      }
    }
  }
}

/// VTK's contours of a triangulated cut with exact values at its nodes come nearer with the square
/// of the triangles' size.
TEST(ContourFilter, ContoursOfTrianglesApproachTheseQuadratically)
{
  const auto grid = Converted(ReadGrid(kToroid));
  const auto plane = MakePlaneAt(0.02);
  Contouring contours(grid, plane);
  contours.filter->SetFieldName("u");
  contours.filter->SetValue(0, 0.02);
  contours.filter->SetTolerance(1e-6);
  vtkPolyData* lines = contours.Output();
  double bounds[6];
  grid->GetBounds(bounds);
  double before = 0.0;
  for (const int n : { 100, 200, 400 })
  {
    vtkNew<vtkPlaneSource> nodes;
    nodes->SetOrigin(bounds[0], bounds[2], 0.02);
    nodes->SetPoint1(bounds[1], bounds[2], 0.02);
    nodes->SetPoint2(bounds[0], bounds[3], 0.02);
    nodes->SetResolution(n, n);
    nodes->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(nodes->GetOutputPort());
    vtkNew<vtkHighOrderProbe> probe;
    probe->SetInputConnection(triangles->GetOutputPort());
    probe->SetSourceData(grid);
    probe->Update();
    probe->GetPolyDataOutput()->GetPointData()->SetActiveScalars("u");
    vtkNew<vtkContourFilter> flat;
    flat->SetInputData(probe->GetOutput());
    flat->SetValue(0, 0.02);
    flat->Update();
    double mean = 0.0;
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < flat->GetOutput()->GetNumberOfPoints(); ++i)
    {
      double x[3];
      flat->GetOutput()->GetPoint(i, x);
      if (std::isfinite(x[0] + x[1]))
      {
        mean += Distance(x, lines);
        ++count;
      }
    }
    ASSERT_GT(count, 100);
    mean /= static_cast<double>(count);
    RecordProperty("mean_distance_" + std::to_string(n), std::to_string(mean));
    std::cout << n << " x " << n << " squares: mean distance " << mean << "\n";
    if (before > 0.0)
    {
      EXPECT_NEAR(before / mean, 4.0, 1.0);
    }
    before = mean;
  }
}

TEST(ContourFilter, FunctionsThatBecomePolynomialsAreCertified)
{
  const auto grid = Boxes(2);
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(0.4, 0.5, 0.45);
  sphere->SetRadius(0.35);
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetCenter(0.4, 0.5, 0.45);
  cylinder->SetAxis(0.3, 1.0, 0.2);
  cylinder->SetRadius(0.25);
  vtkNew<vtkTransform> toTip; // from the world to the cone's own space
  toTip->RotateZ(20.0);
  toTip->Scale(1.0, 1.2, 0.9);
  toTip->Translate(-0.1, -0.5, -0.4);
  vtkNew<vtkCone> cone;
  cone->SetAngle(25.0);
  cone->SetTransform(toTip);
  vtkNew<vtkQuadric> quadric;
  quadric->SetCoefficients(1.0, -0.5, 0.8, 0.3, -0.2, 0.1, -0.6, 0.2, -0.4, 0.1);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.3, 0.4, 0.5);
  plane->SetNormal(1.0, 2.0, -0.5);
  plane->SetTransform(toTip);
  for (vtkImplicitFunction* function :
    std::initializer_list<vtkImplicitFunction*>{ sphere, cylinder, cone, quadric, plane })
  {
    Contouring contours(grid, function);
    contours.filter->GenerateValues(3, 2.0, 3.1);
    vtkPolyData* lines = contours.Output();
    EXPECT_EQ(contours.messages->errors + contours.messages->warnings, "")
      << function->GetClassName();
    EXPECT_GT(lines->GetNumberOfCells(), 0) << function->GetClassName();
    EXPECT_EQ(contours.filter->GetNumberOfUncertifiedLines(), 0);
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      double x[3];
      lines->GetPoint(i, x);
      EXPECT_NEAR(function->FunctionValue(x), 0.0, 2e-15) << function->GetClassName();
    }
  }
}

TEST(ContourFilter, OtherFunctionsAreSearchedAndToldSo)
{
  const auto grid = Boxes(2);
  vtkNew<vtkSuperquadric> superquadric;
  superquadric->SetCenter(0.5, 0.5, 0.5);
  superquadric->SetScale(0.6, 0.6, 0.6);
  superquadric->SetPhiRoundness(0.8);
  superquadric->SetThetaRoundness(0.9);
  superquadric->ToroidalOff();
  Contouring contours(grid, superquadric);
  contours.filter->SetValue(0, 3.0);
  vtkPolyData* lines = contours.Output();
  EXPECT_GT(lines->GetNumberOfCells(), 0);
  EXPECT_EQ(contours.filter->GetNumberOfUncertifiedLines(), lines->GetNumberOfCells());
  EXPECT_NE(contours.messages->warnings.find("not certified"), std::string::npos);
  EXPECT_NE(contours.filter->GetReportText().find("vtkSuperquadric"), std::string::npos);
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double x[3];
    lines->GetPoint(i, x);
    EXPECT_NEAR(superquadric->FunctionValue(x), 0.0, 1e-9);
    EXPECT_NEAR(x[0] + 2.0 * x[1] + 3.0 * x[2], 3.0, 1e-14);
  }
}

TEST(ContourFilter, FollowsItsFunctionAndValues)
{
  const auto grid = Boxes(1);
  const auto plane = MakePlaneAt(0.25);
  Contouring contours(grid, plane);
  EXPECT_EQ(contours.filter->GetNumberOfContours(), 0);
  EXPECT_EQ(contours.Output()->GetNumberOfCells(), 0);
  contours.filter->SetValue(0, 1.5);
  EXPECT_EQ(contours.Output()->GetNumberOfCells(), 1);
  plane->SetOrigin(0.0, 0.0, 0.375);
  EXPECT_EQ(contours.Output()->GetPoint(0)[2], 0.375);
  plane->SetOrigin(0.0, 0.0, 2.0);
  EXPECT_EQ(contours.Output()->GetNumberOfCells(), 0);
}

TEST(ContourFilter, WrongUseIsAnError)
{
  const auto grid = Boxes(1);
  const auto plane = MakePlaneAt(0.25);
  const auto errorOf = [&](auto&& change)
  {
    Contouring contours(grid, plane);
    contours.filter->SetValue(0, 1.5);
    change(contours.filter.Get());
    EXPECT_EQ(contours.Output()->GetNumberOfCells(), 0);
    return std::string(contours.messages->errors);
  };
  using Filter = vtkHighOrderContour*;
  const auto has = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(errorOf([](Filter f) { f->SetCutFunction(nullptr); }), "SetCutFunction"));
  EXPECT_TRUE(has(errorOf([](Filter f) { f->SetFieldName("g"); }), "'g'; choose one of 'f'"));
  EXPECT_TRUE(has(errorOf([](Filter f) { f->SetComponent(1); }), "component 1"));
  EXPECT_TRUE(has(errorOf([](Filter f) { f->SetTolerance(-1.0); }), "tolerance"));
  // Chords as short as that would take all memory.
  EXPECT_TRUE(has(errorOf([](Filter f) { f->SetTolerance(1e-13); }), "1e-10"));
  EXPECT_TRUE(has(errorOf([](Filter f) { f->SetValue(0, std::nan("")); }), "finite"));
  const auto zero = MakePlaneAt(0.0);
  zero->SetNormal(0.0, 0.0, 0.0);
  EXPECT_TRUE(has(errorOf([&](Filter f) { f->SetCutFunction(zero); }), "normal"));
}

TEST(ContourFilter, MappedFieldsAreRefused)
{
  const std::filesystem::path folder =
    std::filesystem::path(PIXELEXACT_DATA_DIR) / "mfem_escher_tet_darcy_p3";
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName((folder / "mfem_escher_tet_darcy_p3.mesh").c_str());
  reader->AddGridFunctionFileName((folder / "flux.gf").c_str());
  reader->Update();
  const auto plane = MakePlaneAt(0.1);
  Contouring refused(reader->GetHighOrderOutput(), plane);
  refused.filter->SetValue(0, 0.1);
  EXPECT_EQ(refused.Output()->GetNumberOfCells(), 0);
  EXPECT_NE(refused.messages->errors.find("H(div)"), std::string::npos);
}
} // namespace
