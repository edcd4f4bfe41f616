// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderCalculator in pipelines: definitions that go with the grid, and what they are worth.
#include "LoadMesh.h"
#include "Support.h"

#include "Core/Element/MeshRanges.h"
#include "Core/Location/Sample.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHighOrderCalculator.h"
#include "vtkHighOrderCertifier.h"
#include "vtkHighOrderProbe.h"
#include "vtkInformation.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

vtkSmartPointer<vtkUnstructuredGrid> Calculated(
  vtkDataObject* grid, const std::string& name, const std::string& text)
{
  vtkNew<vtkHighOrderCalculator> filter;
  filter->SetInputData(grid);
  filter->SetResultArrayName(name);
  filter->SetFunction(text);
  filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

std::string ErrorOf(vtkDataObject* grid, const std::string& name, const std::string& text)
{
  vtkNew<vtkHighOrderCalculator> filter;
  vtkNew<Messages> messages;
  filter->AddObserver(vtkCommand::ErrorEvent, messages);
  filter->SetInputData(grid);
  filter->SetResultArrayName(name);
  filter->SetFunction(text);
  filter->Update();
  return messages->errors;
}

/// The values of a field at some points of each element.
std::vector<double> ValuesOf(vtkDataObject* grid, const std::string& text)
{
  const auto model = HighOrderModel::From(grid);
  const Field& field = model->GetField(text);
  const std::vector<Vec3> xi{ Vec3(0.1, -0.4, 0.3), Vec3(-0.7, 0.2, 0.0) };
  std::vector<double> all;
  std::vector<double> some(xi.size() * static_cast<std::size_t>(field.values.components));
  for (int e = 0; e < model->GetMesh().Elements(); ++e)
  {
    EvaluateAt(model->GetMesh(), field, e, xi, some, {});
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

TEST(Calculator, DefinitionsGoThroughPipelinesAndFiles)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  const auto slope = Calculated(grid, "slope", "mag(grad(u))");
  const auto both = Calculated(slope, "double slope", "2*slope");
  const std::vector<double> direct = ValuesOf(slope, "2*mag(grad(u))");
  EXPECT_EQ(ValuesOf(both, "double slope"), direct);
  EXPECT_EQ(ValuesOf(both, "\"double slope\" + 0*slope"), direct);

  const auto file = std::filesystem::temp_directory_path() / "pixelexact_calculator.vtu";
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(both);
  writer->SetFileName(file.string().c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.string().c_str());
  reader->Update();
  EXPECT_EQ(ValuesOf(reader->GetOutput(), "double slope"), direct);
  std::filesystem::remove(file);
}

TEST(Calculator, PointValuesAreTheExpressionsThere)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  const auto output = Calculated(grid, "e", "u - x*y + 1");
  vtkDataArray* u = output->GetPointData()->GetArray("u");
  vtkDataArray* e = output->GetPointData()->GetArray("e");
  ASSERT_NE(e, nullptr);
  ASSERT_EQ(e->GetNumberOfTuples(), grid->GetNumberOfPoints());
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    const double* x = grid->GetPoint(p);
    EXPECT_NEAR(e->GetTuple1(p), u->GetTuple1(p) - x[0] * x[1] + 1.0, 1e-12);
  }
  vtkNew<vtkHighOrderCalculator> bare;
  bare->SetInputData(grid);
  bare->SetFunction("u");
  bare->PointValuesOff();
  bare->Update();
  EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(bare->GetOutputDataObject(0))
              ->GetPointData()
              ->GetArray("result"),
    nullptr);
}

TEST(Calculator, KnowsTheTimeAndParametersOfTheGrid)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  vtkNew<vtkDoubleArray> reynolds;
  reynolds->SetName("Re");
  reynolds->InsertNextValue(40.0);
  grid->GetFieldData()->AddArray(reynolds);
  grid->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 2.5);
  const Conversion conversion(grid);
  conversion.Output()->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 2.5);
  for (const double value : ValuesOf(conversion.Output(), "Re + t + 0*u"))
  {
    EXPECT_EQ(value, 42.5);
  }
}

TEST(Calculator, WrongUseIsNamed)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  const auto says = [&](const std::string& name, const std::string& text, const std::string& part)
  {
    const std::string error = ErrorOf(grid, name, text);
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  says("", "u", "the new field has no name");
  says("e", "", "there is no expression");
  says("u", "2*u", "the grid has a field 'u'");
  says("e", "2*w", "nothing is named 'w'");
  says("e", "mag(grad(u)", "something is missing at the end");
}

TEST(Calculator, RangesOfExpressionsAreProven)
{
  const auto output = Calculated(ReadGrid(kData / "toroid_hex_g3_p6.vtu"), "e", "u^2");
  vtkNew<vtkHighOrderCertifier> certifier;
  vtkNew<Messages> messages;
  certifier->AddObserver(vtkCommand::ErrorEvent, messages);
  const auto rangesOf = [&](const char* field)
  {
    certifier->SetInputData(output);
    certifier->SetFieldName(field);
    certifier->Update();
    const std::string name = field;
    vtkCellData* const cells =
      vtkDataSet::SafeDownCast(certifier->GetOutputDataObject(0))->GetCellData();
    std::vector<std::array<double, 2>> ranges;
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      ranges.push_back({ cells->GetArray((name + "_lower").c_str())->GetComponent(cell, 0),
        cells->GetArray((name + "_upper").c_str())->GetComponent(cell, 0) });
    }
    return ranges;
  };
  const auto squares = rangesOf("e");
  const auto values = rangesOf("u");
  EXPECT_EQ(messages->errors, "");
  // Both are within the tolerance of the filter.
  for (std::size_t e = 0; e < values.size(); ++e)
  {
    const auto [lower, upper] = values[e];
    const double most = std::max(lower * lower, upper * upper);
    const double least = lower < 0.0 && upper > 0.0 ? 0.0 : std::min(lower * lower, upper * upper);
    EXPECT_NEAR(squares[e][1], most, 2e-2 * most);
    EXPECT_NEAR(squares[e][0], least, 2e-2 * most);
    EXPECT_GE(squares[e][0], 0.0);
  }
}
} // namespace
