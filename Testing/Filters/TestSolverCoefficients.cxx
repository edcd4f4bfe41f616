// SPDX-License-Identifier: BSD-3-Clause
// Grids whose coefficients came from a solver's own file are not converted from their nodes.
#include "Support.h"

#include "Core/Base/Error.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkFieldData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// One box whose field "p" = 1 + 2 xi1 has no nodal values.
vtkSmartPointer<vtkHighOrderGrid> SolverGrid()
{
  auto grid = Converted(Boxes(1));
  OwnedExpansion p;
  const Space space{ Shape::Hexahedron, Form::Collapsed, { 1, 0, 0 } };
  p.Allocate({ &space, 1 }, 1);
  p.Coefficients(0)[0] = 1.0;
  p.Coefficients(0)[1] = 2.0;
  StoreField(grid, "p", { std::move(p) }, Origin::Coefficients);
  return grid;
}

TEST(SolverCoefficients, AreRead)
{
  const auto grid = SolverGrid();
  ASSERT_EQ(vtkHighOrderGrid::CheckCoefficients(grid), "");
  vtkNew<vtkDoubleArray> value;
  const double xi[3] = { 0.25, 0.9, -0.9 };
  ASSERT_TRUE(grid->EvaluateField("p", 0, xi, value));
  EXPECT_DOUBLE_EQ(value->GetValue(0), 1.5);
}

TEST(SolverCoefficients, PassTheConverter)
{
  Conversion conversion(SolverGrid());
  ASSERT_TRUE(conversion.done);
  EXPECT_EQ(conversion.messages->warnings, "");
  EXPECT_EQ(conversion.Output()->GetNumberOfHighOrderFields(), 2);
}

TEST(SolverCoefficients, AreDroppedAloudWhenStale)
{
  const auto grid = SolverGrid();
  grid->GetPoints()->SetPoint(0, -0.5, 0.0, 0.0);
  grid->GetPoints()->Modified();
  Conversion conversion(grid);
  ASSERT_TRUE(conversion.done);
  EXPECT_NE(conversion.messages->warnings.find("solver's own coefficients"), std::string::npos);
  EXPECT_EQ(conversion.Output()->GetNumberOfHighOrderFields(), 1);
}

TEST(SolverCoefficients, ReplaceEarlierOnes)
{
  // The second "f" has no nodal values: a left-over fingerprint would be compared with the wrong.
  const auto grid = Converted(Boxes(1));
  OwnedExpansion f;
  const Space space = UniformSpace(Shape::Hexahedron, 0);
  f.Allocate({ &space, 1 }, 1);
  f.Coefficients(0)[0] = 7.0;
  StoreField(grid, "f", { std::move(f) }, Origin::Coefficients);
  ASSERT_EQ(vtkHighOrderGrid::CheckCoefficients(grid), "");
  vtkNew<vtkDoubleArray> value;
  const double xi[3] = { 0.0, 0.0, 0.0 };
  ASSERT_TRUE(grid->EvaluateField("f", 0, xi, value));
  EXPECT_EQ(value->GetValue(0), 7.0);
}

TEST(SolverCoefficients, NamesMayContainDots)
{
  const auto grid = Boxes(1);
  AddPointField(grid, "f.x", std::vector<double>(8, 1.0));
  AddPointField(grid, "f.Coefficients", std::vector<double>(8, 2.0));
  const auto output = Converted(grid);
  EXPECT_EQ(output->GetNumberOfHighOrderFields(), 3);
  vtkNew<vtkDoubleArray> value;
  const double xi[3] = { 0.0, 0.0, 0.0 };
  ASSERT_TRUE(output->EvaluateField("f.Coefficients", 0, xi, value));
  EXPECT_DOUBLE_EQ(value->GetValue(0), 2.0);
  ASSERT_TRUE(output->EvaluateField("f", 0, xi, value));
  EXPECT_DOUBLE_EQ(value->GetValue(0), 3.0);
}

TEST(SolverCoefficients, KeepTheirMapping)
{
  const auto grid = Converted(Boxes(1));
  const auto store = [&](int components, Mapping mapping)
  {
    const Space space = UniformSpace(Shape::Hexahedron, 0);
    OwnedExpansion v;
    v.Allocate({ &space, 1 }, components);
    std::ranges::fill(v.coefficients, 1.0);
    StoreField(grid, "v", { std::move(v), mapping }, Origin::Coefficients);
    return vtkHighOrderGrid::CheckCoefficients(grid);
  };
  for (const auto mapping : { Mapping::Covariant, Mapping::Contravariant })
  {
    EXPECT_EQ(store(3, mapping), "");
    EXPECT_EQ(HighOrderModel::From(grid)->FindField("v")->mapping, mapping);
    EXPECT_NE(store(1, mapping).find("components"), std::string::npos);
    EXPECT_NE(store(4, mapping).find("components"), std::string::npos);
  }
  EXPECT_EQ(store(1, Mapping::Density), "");
  EXPECT_EQ(HighOrderModel::From(grid)->FindField("v")->mapping, Mapping::Density);
  EXPECT_NE(store(3, static_cast<Mapping>(9)).find("unknown mapping 9"), std::string::npos);
  // Nothing of the earlier mappings is left over.
  EXPECT_EQ(store(1, Mapping::Identity), "");
  EXPECT_EQ(HighOrderModel::From(grid)->FindField("v")->mapping, Mapping::Identity);
}

TEST(SolverCoefficients, NeedOneElementPerCell)
{
  const auto grid = Boxes(2);
  EXPECT_THROW(StoreMesh(grid, {}, Origin::Coefficients), InvalidData);
}
} // namespace
