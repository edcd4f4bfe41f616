// SPDX-License-Identifier: BSD-3-Clause
// VTK's Bezier quadrilaterals and plain control points, as patches: against VTK's own evaluation.
#include "Window.h"

#include "Surfaces/VtkPatches.h"

#include "Core/Base/Error.h"
#include "vtkHighOrderPatchSurface.h"

#include "vtkBezierQuadrilateral.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>

namespace pixelexact
{
namespace
{
using testing::Contains;

/// The patch at (u, v), by de Casteljau's rule.
std::array<long double, 3> Evaluate(const BezierPatch& patch, double u, double v)
{
  const auto along = [](std::vector<std::array<long double, 3>> points, long double s)
  {
    for (std::size_t left = points.size(); left > 1; --left)
    {
      for (std::size_t k = 0; k + 1 < left; ++k)
      {
        for (std::size_t d = 0; d < 3; ++d)
        {
          points[k][d] = (1.0L - s) * points[k][d] + s * points[k + 1][d];
        }
      }
    }
    return points[0];
  };
  std::vector<std::array<long double, 3>> column;
  for (int i = 0; i <= patch.degree[0]; ++i)
  {
    std::vector<std::array<long double, 3>> row;
    for (int j = 0; j <= patch.degree[1]; ++j)
    {
      const Vec3& p =
        patch.points[static_cast<std::size_t>(i) * (static_cast<std::size_t>(patch.degree[1]) + 1) +
          static_cast<std::size_t>(j)];
      row.push_back({ p.x, p.y, p.z });
    }
    column.push_back(along(row, v));
  }
  return along(column, u);
}

/// One cell of random points. An array gives the degrees where they differ or `tellDegrees` is set.
vtkSmartPointer<vtkUnstructuredGrid> Cell(int nu, int nv, bool tellDegrees)
{
  std::mt19937 random(static_cast<unsigned>(10 * nu + nv));
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids(static_cast<std::size_t>((nu + 1) * (nv + 1)));
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    points->InsertNextPoint(number(random), number(random), number(random));
  }
  // The ids are not in the order of the points.
  std::iota(ids.rbegin(), ids.rend(), vtkIdType{ 0 });
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_BEZIER_QUADRILATERAL, static_cast<vtkIdType>(ids.size()), ids.data());
  if (tellDegrees)
  {
    vtkNew<vtkDoubleArray> degrees;
    degrees->SetNumberOfComponents(3);
    degrees->InsertNextTuple3(nu, nv, 0);
    grid->GetCellData()->SetHigherOrderDegrees(degrees);
  }
  return grid;
}

void SetWeights(vtkUnstructuredGrid* grid, double first, double others)
{
  vtkNew<vtkDoubleArray> weights;
  for (vtkIdType k = 0; k < grid->GetNumberOfPoints(); ++k)
  {
    weights->InsertNextValue(k == 0 ? first : others);
  }
  grid->GetPointData()->SetRationalWeights(weights);
}

std::string Refusal(vtkPointSet* data)
{
  try
  {
    (void)ToPatches(data);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(VtkPatches, AreThePointsThatVtkEvaluates)
{
  int compared = 0;
  for (int nu = 1; nu <= 5; ++nu)
  {
    for (int nv = 1; nv <= 5; ++nv)
    {
      const auto grid = Cell(nu, nv, nu != nv || nu % 2 == 0);
      const std::vector<BezierPatch> patches = ToPatches(grid);
      ASSERT_EQ(patches.size(), 1U);
      EXPECT_EQ(patches[0].degree[0], nu);
      EXPECT_EQ(patches[0].degree[1], nv);
      for (const double u : { 0.0, 0.2, 0.7, 1.0 })
      {
        for (const double v : { 0.0, 0.4, 0.9, 1.0 })
        {
          const double at[3] = { u, v, 0.0 };
          int part = 0;
          double x[3];
          std::vector<double> weights(static_cast<std::size_t>((nu + 1) * (nv + 1)));
          grid->GetCell(0)->EvaluateLocation(part, at, x, weights.data());
          const auto ours = Evaluate(patches[0], u, v);
          for (std::size_t d = 0; d < 3; ++d)
          {
            ++compared;
            EXPECT_NEAR(static_cast<double>(ours[d]), x[d], 1e-14) << nu << " x " << nv;
          }
        }
      }
    }
  }
  EXPECT_EQ(compared, 25 * 16 * 3);
}

TEST(VtkPatches, PlainPointsAreBicubicRowsOfU)
{
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 32; ++k)
  {
    const int row = k / 4;
    const int patch = k / 16;
    points->InsertNextPoint(row, k % 4, patch);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  const auto expect = [&]
  {
    const std::vector<BezierPatch> patches = ToPatches(data);
    ASSERT_EQ(patches.size(), 2U);
    EXPECT_EQ(patches[1].degree[0], 3);
    EXPECT_EQ(patches[1].degree[1], 3);
    EXPECT_EQ(patches[1].points.at(4 * 2 + 3), Vec3(6.0, 3.0, 1.0));
  };
  expect();
  // The input of a table of points.
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType k = 0; k < 32; ++k)
  {
    vertices->InsertNextCell(1, &k);
  }
  data->SetVerts(vertices);
  expect();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  EXPECT_TRUE(Contains(Refusal(data), "33 points")) << Refusal(data);
}

TEST(VtkPatches, WhatIsNoneIsRefusedByName)
{
  const auto grid = Cell(2, 2, false);
  SetWeights(grid, 0.5, 0.5);
  EXPECT_EQ(Refusal(grid), "");
  SetWeights(grid, 0.5, 1.0);
  EXPECT_TRUE(Contains(Refusal(grid), "cell 0 has rational weights")) << Refusal(grid);
  SetWeights(grid, 0.0, 0.0);
  EXPECT_TRUE(Contains(Refusal(grid), "rational weights")) << Refusal(grid);
  const auto wrong = Cell(2, 3, false);
  EXPECT_TRUE(Contains(Refusal(wrong), "12 points")) << Refusal(wrong);
  const auto nan = Cell(1, 1, false);
  nan->GetPoints()->SetPoint(2, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  EXPECT_TRUE(Contains(Refusal(nan), "point 2 is not finite")) << Refusal(nan);
  const vtkIdType square[4] = { 0, 1, 2, 3 };
  const auto mixed = Cell(1, 1, false);
  mixed->InsertNextCell(VTK_QUAD, 4, square);
  EXPECT_TRUE(Contains(Refusal(mixed), "cell 1 is a vtkQuad")) << Refusal(mixed);
  vtkNew<vtkPolyData> nothing;
  EXPECT_TRUE(Contains(Refusal(nothing), "0 points")) << Refusal(nothing);
}

TEST(VtkPatches, TheClassChangesWithItsInput)
{
  vtkNew<vtkHighOrderPatchSurface> surface;
  EXPECT_EQ(surface->GetInput(), nullptr);
  const auto grid = Cell(3, 3, false);
  vtkMTimeType before = surface->GetMTime();
  surface->SetInputData(grid);
  EXPECT_GT(surface->GetMTime(), before);
  before = surface->GetMTime();
  grid->Modified();
  EXPECT_GT(surface->GetMTime(), before);
  surface->Update();
  EXPECT_EQ(surface->GetInput(), grid.Get());
}
} // namespace pixelexact
