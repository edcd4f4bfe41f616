// SPDX-License-Identifier: BSD-3-Clause
// What VTK's filters leave of the coefficients: whole cells stay good, the rest is refused.
#include "Support.h"

#include "Core/Location/Locator.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "vtkMFEMReader.h"

#include "vtkAppendFilter.h"
#include "vtkArrayCalculator.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkClipDataSet.h"
#include "vtkElevationFilter.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPassArrays.h"
#include "vtkPlane.h"
#include "vtkThreshold.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkWarpVector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

class Staleness : public ::testing::Test
{
protected:
  vtkSmartPointer<vtkHighOrderGrid> Grid = Converted(Boxes(3));

  template <class Filter>
  vtkSmartPointer<vtkUnstructuredGrid> Run(Filter& filter)
  {
    filter.SetInputData(Grid);
    filter.Update();
    return vtkUnstructuredGrid::SafeDownCast(filter.GetOutputDataObject(0));
  }

  static void ExpectFine(vtkUnstructuredGrid* grid)
  {
    ASSERT_NE(grid, nullptr);
    EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(grid), "");
  }
  static void ExpectStale(vtkUnstructuredGrid* grid, const std::string& word)
  {
    ASSERT_NE(grid, nullptr);
    const std::string problem = vtkHighOrderGrid::CheckCoefficients(grid);
    EXPECT_NE(problem.find(word), std::string::npos) << problem;
    EXPECT_NE(problem.find("vtkUnstructuredGridToHighOrderGrid"), std::string::npos) << problem;
    // The remedy works.
    Conversion again(grid);
    EXPECT_EQ(again.messages->errors, "");
    EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(again.Output()), "");
  }
  /// Every element maps its centre to the middle of its cell's points.
  static void ExpectInPlace(vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkHighOrderGrid> view;
    view->ShallowCopy(grid);
    const double origin[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      double bounds[6];
      grid->GetCellBounds(cell, bounds);
      double x[3];
      ASSERT_TRUE(view->MapForward(cell, origin, x));
      vtkNew<vtkDoubleArray> value;
      ASSERT_TRUE(view->EvaluateField("f", cell, origin, value));
      for (int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(x[d], (bounds[2 * d] + bounds[2 * d + 1]) / 2, 1e-15);
      }
      EXPECT_NEAR(value->GetValue(0), x[0] + 2 * x[1] + 3 * x[2], 1e-14);
    }
  }
};

TEST_F(Staleness, ConversionIsCurrent)
{
  ExpectFine(Grid);
  ExpectInPlace(Grid);
  EXPECT_EQ(Grid->GetDataObjectType(), VTK_UNSTRUCTURED_GRID);
}

TEST_F(Staleness, InputIsLeftAlone)
{
  const auto input = Boxes(2);
  const auto output = Converted(input);
  EXPECT_FALSE(vtkHighOrderGrid::IsHighOrder(input));
  EXPECT_TRUE(vtkHighOrderGrid::IsHighOrder(output));
  EXPECT_EQ(input->GetCellData()->GetNumberOfArrays(), 0);
}

TEST_F(Staleness, CopiesKeepAll)
{
  vtkNew<vtkUnstructuredGrid> shallow;
  shallow->ShallowCopy(Grid);
  ExpectFine(shallow);
  vtkNew<vtkUnstructuredGrid> deep;
  deep->DeepCopy(Grid);
  ExpectFine(deep);
  ExpectInPlace(deep);
}

TEST_F(Staleness, CopyStructureLosesAll)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->CopyStructure(Grid);
  EXPECT_FALSE(vtkHighOrderGrid::IsHighOrder(copy));
  EXPECT_NE(vtkHighOrderGrid::CheckCoefficients(copy), "");
}

TEST_F(Staleness, ThresholdKeepsWholeCells)
{
  vtkNew<vtkThreshold> filter;
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f");
  filter->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  filter->SetUpperThreshold(3.0);
  const auto out = Run(*filter);
  ASSERT_GT(out->GetNumberOfCells(), 0);
  ASSERT_LT(out->GetNumberOfCells(), 27);
  ExpectFine(out);
  ExpectInPlace(out);
}

TEST_F(Staleness, ExtractCellsKeepsSourceNumbers)
{
  vtkNew<vtkIdList> ids;
  for (const vtkIdType id : { 20, 3, 7 })
  {
    ids->InsertNextId(id);
  }
  vtkNew<vtkExtractCells> filter;
  filter->SetCellList(ids);
  const auto out = Run(*filter);
  ExpectFine(out);
  ExpectInPlace(out);
  const auto model = HighOrderModel::From(out);
  const auto cells = model->SourceCells();
  EXPECT_EQ(
    std::set<std::int64_t>(cells.begin(), cells.end()), (std::set<std::int64_t>{ 3, 7, 20 }));
  // Coefficients are viewed, not copied.
  EXPECT_EQ(model->GetMesh().map.coefficients.data(),
    vtkDoubleArray::SafeDownCast(out->GetFieldData()->GetArray("PixelExact.Mesh.Coefficients"))
      ->GetPointer(0));
}

TEST_F(Staleness, ClipIsStale)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.5, 0.5);
  vtkNew<vtkClipDataSet> filter;
  filter->SetClipFunction(plane);
  const auto out = Run(*filter);
  ExpectStale(out, "(Clip)");
  ExpectStale(out, "(Append)");
}

TEST_F(Staleness, AppendIsStale)
{
  const auto other = Converted(Boxes(2));
  vtkNew<vtkAppendFilter> filter;
  filter->AddInputData(Grid);
  filter->AddInputData(other);
  filter->Update();
  vtkUnstructuredGrid* out = filter->GetOutput();
  if (vtkHighOrderGrid::IsHighOrder(out)) // newer versions of VTK drop FieldData
  {
    ExpectStale(out, "cell ");
  }
}

TEST_F(Staleness, AppendOfItsPartsIsFine)
{
  vtkNew<vtkAppendFilter> append;
  for (const int from : { 10, 0 })
  {
    vtkNew<vtkExtractCells> part;
    part->AddCellRange(from, from == 0 ? 9 : 26);
    append->AddInputData(Run(*part));
  }
  append->Update();
  if (vtkHighOrderGrid::IsHighOrder(append->GetOutput()))
  {
    ExpectFine(append->GetOutput());
    ExpectInPlace(append->GetOutput());
  }
}

TEST_F(Staleness, TransformIsStale)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(1e-9, 0.0, 0.0);
  vtkNew<vtkTransformFilter> filter;
  filter->SetTransform(transform);
  ExpectStale(Run(*filter), "moved");
}

TEST_F(Staleness, WarpIsStale)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("w");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(Grid->GetNumberOfPoints());
  vectors->Fill(0.0);
  vectors->SetComponent(5, 1, 0.01); // one point only
  Grid->GetPointData()->SetVectors(vectors);
  ExpectFine(Grid);
  vtkNew<vtkWarpVector> filter;
  ExpectStale(Run(*filter), "moved");
}

TEST_F(Staleness, NewArraysAreFine)
{
  vtkNew<vtkElevationFilter> elevation;
  ExpectFine(Run(*elevation));
  vtkNew<vtkArrayCalculator> calculator;
  calculator->AddScalarArrayName("f");
  calculator->SetFunction("f + 1");
  calculator->SetResultArrayName("g");
  ExpectFine(Run(*calculator));
}

TEST_F(Staleness, ChangedFieldIsStale)
{
  vtkNew<vtkArrayCalculator> calculator;
  calculator->AddScalarArrayName("f");
  calculator->SetFunction("f + 1");
  calculator->SetResultArrayName("f");
  ExpectStale(Run(*calculator), "'f'");
}

TEST_F(Staleness, ChangeInPlaceIsSeen)
{
  ExpectFine(Grid);
  Grid->GetPointData()->GetArray("f")->SetComponent(0, 0, 17.0);
  Grid->GetPointData()->GetArray("f")->Modified();
  ExpectStale(Grid, "'f'");
}

TEST_F(Staleness, ZeroHasOneSign)
{
  vtkDataArray* field = Grid->GetPointData()->GetArray("f");
  ASSERT_EQ(field->GetComponent(0, 0), 0.0);
  Grid->GetPoints()->SetPoint(0, -0.0, -0.0, -0.0);
  field->SetComponent(0, 0, -0.0);
  Grid->Modified();
  ExpectFine(Grid);
  field->SetComponent(0, 0, std::numeric_limits<double>::denorm_min());
  field->Modified();
  ExpectStale(Grid, "'f'");
}

TEST_F(Staleness, DroppedNodalValuesAreFine)
{
  vtkNew<vtkPassArrays> filter;
  filter->UseFieldTypesOn();
  filter->AddFieldType(vtkDataObject::POINT);
  const auto out = Run(*filter);
  EXPECT_EQ(out->GetPointData()->GetArray("f"), nullptr);
  ASSERT_TRUE(vtkHighOrderGrid::IsHighOrder(out));
  ExpectFine(out);
  ExpectInPlace(out);
}

TEST_F(Staleness, ArraysWithoutAnOriginAreNotFollowed)
{
  Grid->GetFieldData()->RemoveArray("PixelExact.Mesh.Origin");
  Conversion again(Grid); // as of a grid without coefficients
  EXPECT_EQ(again.messages->errors, "");
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(again.Output()), "");
}

TEST_F(Staleness, WithoutIdsOnlyAllCellsFit)
{
  Grid->GetCellData()->RemoveArray("PixelExactElementId");
  ExpectFine(Grid);
  vtkNew<vtkExtractCells> part;
  part->AddCellRange(0, 9);
  ExpectStale(Run(*part), "PixelExactElementId");
}

TEST_F(Staleness, ModelIsSharedWhileCurrent)
{
  const auto first = HighOrderModel::From(Grid);
  EXPECT_EQ(HighOrderModel::From(Grid), first);
  EXPECT_EQ(Grid->GetModel(), first);
  EXPECT_FALSE(first->HasLocator());
  EXPECT_EQ(first->GetLocator().GetMesh().Elements(), 27);
  EXPECT_TRUE(first->HasLocator());
  Grid->Modified();
  EXPECT_FALSE(first->IsCurrent(Grid));
  EXPECT_NE(HighOrderModel::From(Grid), first);
}

TEST_F(Staleness, ModelOutlivesTheGrid)
{
  const auto model = HighOrderModel::From(Grid);
  Grid = nullptr;
  EXPECT_EQ(model->GetMesh().Elements(), 27);
  EXPECT_FALSE(model->GetLocator().Bounds().Contains(Vec3(2.0)));
}

/// The output of a solver's reader: coefficients of order 3 and more, with linear cells.
class NativeStaleness : public ::testing::Test
{
protected:
  using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

  static Grid Read(
    const std::string& folder, const std::string& mesh, const std::vector<std::string>& functions)
  {
    const std::string path = std::string(PIXELEXACT_DATA_DIR "/") + folder + "/";
    vtkNew<vtkMFEMReader> reader;
    reader->SetCells(vtkHighOrderFileReader::CORNER_CELLS);
    reader->SetFileName((path + mesh).c_str());
    for (const auto& function : functions)
    {
      reader->AddGridFunctionFileName((path + function).c_str());
    }
    reader->Update();
    return reader->GetOutput();
  }
  /// A continuous field, so with values at points.
  static Grid Zoo()
  {
    return Read("mfem49_tinyzoo_g3_p5", "mfem49_tinyzoo_g3_p5.mesh", { "u.gf" });
  }
  /// A field of L2 and one of H(div), so with values of cells.
  static Grid Darcy()
  {
    return Read(
      "mfem_escher_tet_darcy_p3", "mfem_escher_tet_darcy_p3.mesh", { "pressure.gf", "flux.gf" });
  }

  static Grid Calculated(vtkUnstructuredGrid* grid, bool ofCells, const std::string& formula,
    const std::string& name, const std::string& result)
  {
    vtkNew<vtkArrayCalculator> calculator;
    calculator->SetInputData(grid);
    calculator->SetAttributeType(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
    calculator->AddScalarArrayName(name.c_str());
    calculator->SetFunction(formula.c_str());
    calculator->SetResultArrayName(result.c_str());
    calculator->Update();
    return vtkUnstructuredGrid::SafeDownCast(calculator->GetOutput());
  }
  static Grid Moved(vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkTransform> transform;
    transform->Scale(2.0, 1.0, 1.0);
    vtkNew<vtkTransformFilter> filter;
    filter->SetTransform(transform);
    filter->SetInputData(grid);
    filter->Update();
    return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  }

  /// Refused, without the advice to convert, by model and converter.
  static void ExpectRefused(vtkUnstructuredGrid* grid, const std::string& word)
  {
    const std::string problem = vtkHighOrderGrid::CheckCoefficients(grid);
    EXPECT_NE(problem.find(word), std::string::npos) << problem;
    EXPECT_NE(problem.find("a conversion would lose"), std::string::npos) << problem;
    EXPECT_EQ(problem.find("vtkUnstructuredGridToHighOrderGrid again"), std::string::npos)
      << problem;
    Conversion conversion(grid);
    EXPECT_FALSE(conversion.done);
    EXPECT_NE(conversion.messages->errors.find("a conversion would lose"), std::string::npos)
      << conversion.messages->errors << conversion.messages->warnings;
  }
};

TEST_F(NativeStaleness, AFieldThatAFilterChangedIsStale)
{
  ExpectRefused(Calculated(Zoo(), false, "2*u", "u", "u"), "'u'");
  ExpectRefused(Calculated(Darcy(), true, "2*pressure", "pressure", "pressure"), "'pressure'");
  const Grid grid = Zoo();
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(grid), "");
  vtkDataArray* u = grid->GetPointData()->GetArray("u");
  u->SetComponent(0, 0, u->GetComponent(0, 0) + 1e-12);
  u->Modified();
  ExpectRefused(grid, "'u'");
}

TEST_F(NativeStaleness, WhatIsNotTheFieldMayBeChanged)
{
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(Zoo()), "");
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(Darcy()), "");
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(Calculated(Zoo(), false, "1*u", "u", "u")), "");
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(Calculated(Zoo(), false, "2*u", "u", "v")), "");
  const Grid dropped = Darcy();
  dropped->GetCellData()->RemoveArray("pressure");
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(dropped), "");
  for (const Grid& grid : { Zoo(), Darcy() })
  {
    vtkNew<vtkExtractCells> some;
    some->SetInputData(grid);
    some->AddCellRange(1, 2);
    some->Update();
    EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(some->GetOutput()), "");
  }
}

TEST_F(NativeStaleness, ArraysOfTheSameNameElsewhereAreToldApart)
{
  const Grid cells = Darcy(); // "pressure" is shown by cell data
  EXPECT_FALSE(HasNamesake(cells, "pressure", true));
  EXPECT_FALSE(HasNamesake(cells, "pressure", false));
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputData(cells);
  average->PassCellDataOn();
  average->Update();
  auto* const both = vtkUnstructuredGrid::SafeDownCast(average->GetOutput());
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(both), "");
  EXPECT_TRUE(HasNamesake(both, "pressure", true));
  EXPECT_FALSE(HasNamesake(both, "pressure", false));
  EXPECT_FALSE(HasNamesake(Zoo(), "u", true));
  EXPECT_FALSE(HasNamesake(Zoo(), "v", true));
}

TEST_F(NativeStaleness, MovedCellsAreNotLinearized)
{
  ExpectRefused(Moved(Darcy()), "moved"); // nothing at the points shows that the cells are whole
}

TEST_F(NativeStaleness, LostCoefficientsAreNotLinearized)
{
  // The grid after VTK's filters that drop FieldData.
  const Grid grid = Zoo();
  grid->GetFieldData()->Initialize();
  ASSERT_FALSE(vtkHighOrderGrid::IsHighOrder(grid));
  ExpectRefused(grid, "no high-order coefficients");
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputData(grid);
  average->Update();
  ExpectRefused(
    vtkUnstructuredGrid::SafeDownCast(average->GetOutput()), "no high-order coefficients");
}

TEST_F(NativeStaleness, CellsThatHoldAllAreConverted)
{
  // Trilinear elements with a field of order 1, as a solver's.
  const auto grid = Converted(Boxes(2));
  const auto model = HighOrderModel::From(grid);
  const Field& f = *model->FindField("f");
  OwnedExpansion values;
  const Space space{ Shape::Hexahedron, Form::Collapsed, { 1, 1, 1 } };
  values.Allocate(std::vector<Space>(8, space), 1);
  std::ranges::copy(f.values.coefficients, values.coefficients.begin());
  StoreField(grid, "f", { std::move(values) }, Origin::SolverPoints);
  ASSERT_EQ(vtkHighOrderGrid::CheckCoefficients(grid), "");
  const Grid moved = Moved(grid);
  EXPECT_NE(
    vtkHighOrderGrid::CheckCoefficients(moved).find("run vtkUnstructuredGridToHighOrderGrid again"),
    std::string::npos);
  Conversion again(moved);
  ASSERT_TRUE(again.done) << again.messages->errors;
  vtkNew<vtkDoubleArray> value;
  double x[3];
  const double xi[3] = { 0.3, -0.2, 0.9 };
  ASSERT_TRUE(again.Output()->MapForward(3, xi, x));
  ASSERT_TRUE(again.Output()->EvaluateField("f", 3, xi, value));
  EXPECT_NEAR(value->GetValue(0), x[0] / 2.0 + 2.0 * x[1] + 3.0 * x[2], 1e-14);
}

TEST_F(NativeStaleness, WhatIsCutOutOfCurvedCellsIsNotLinearized)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 0.2, 1.0);
  vtkNew<vtkClipDataSet> clip;
  clip->SetClipFunction(plane);
  clip->SetInputData(Converted(ReadGrid(PIXELEXACT_DATA_DIR "/escher_tet_g3_p3.vtu")));
  clip->Update();
  ExpectRefused(clip->GetOutput(), "(Clip)");
}
} // namespace
