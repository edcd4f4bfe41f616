// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Support.h"

#include "HighOrderModel.h"
#include "vtkHighOrderProbe.h"
#include "vtkHighOrderSeriesReader.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace pixelexact::testing
{
inline constexpr double kDegree = 2;

/// A polynomial of total degree 2, which a triquadratic Lagrange hexahedron holds exactly.
inline double Exact(const Vec3& x, double t)
{
  return 1.0 + t * x.x - 2.0 * x.y * x.z + (t + 1.0) * x.x * x.x;
}

/// Lagrange hexahedra of order 2, [lower, lower + cells] x [0,1]^2, with u = Exact(x, t).
inline vtkSmartPointer<vtkUnstructuredGrid> Slabs(int lower, int cells, double t)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<double> u;
  grid->SetPoints(points);
  grid->Allocate(cells);
  vtkNew<vtkIdTypeArray> number;
  number->SetName("number");
  for (int c = 0; c < cells; ++c)
  {
    // VTK's own order of the 27 nodes, from its parametric coordinates.
    static const int nodes[27][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
      { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 },
      { 0, 1, 0 }, { 1, 0, 2 }, { 2, 1, 2 }, { 1, 2, 2 }, { 0, 1, 2 }, { 0, 0, 1 }, { 2, 0, 1 },
      { 2, 2, 1 }, { 0, 2, 1 }, { 0, 1, 1 }, { 2, 1, 1 }, { 1, 0, 1 }, { 1, 2, 1 }, { 1, 1, 0 },
      { 1, 1, 2 }, { 1, 1, 1 } };
    std::vector<vtkIdType> ids;
    for (const auto& node : nodes)
    {
      const Vec3 x(lower + c + node[0] / kDegree, node[1] / kDegree, node[2] / kDegree);
      ids.push_back(points->InsertNextPoint(x.x, x.y, x.z));
      u.push_back(Exact(x, t));
    }
    grid->InsertNextCell(72, 27, ids.data()); // VTK_LAGRANGE_HEXAHEDRON
    number->InsertNextValue(lower + c);
  }
  AddPointField(grid, "u", u);
  grid->GetCellData()->AddArray(number);
  return grid;
}

/// A folder of files, and a pipeline of reader, converter and probe that complains to Heard.
class SeriesFiles : public ::testing::Test
{
protected:
  std::filesystem::path Folder = std::filesystem::temp_directory_path() /
    ("pixelexact-" + std::to_string(getpid()) + "-" +
      ::testing::UnitTest::GetInstance()->current_test_info()->name());
  vtkNew<vtkHighOrderSeriesReader> Reader;
  vtkNew<vtkUnstructuredGridToHighOrderGrid> Converter;
  vtkNew<vtkHighOrderProbe> Probe;
  vtkNew<Messages> Heard;

  SeriesFiles()
  {
    std::filesystem::create_directories(Folder);
    Heard->Watch(Reader);
    Heard->Watch(Converter);
    Heard->Watch(Probe);
    Heard->Watch(Reader->GetExecutive());
    Heard->Watch(Converter->GetExecutive());
    Heard->Watch(Probe->GetExecutive());
    Converter->SetInputConnection(Reader->GetOutputPort());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const double x : { 0.3, 1.7, 2.9 })
    {
      points->InsertNextPoint(x, 0.4, 0.85);
    }
    vtkNew<vtkPolyData> where;
    where->SetPoints(points);
    Probe->SetInputData(where);
    Probe->SetSourceConnection(Converter->GetOutputPort());
  }
  ~SeriesFiles() override { std::filesystem::remove_all(Folder); }

  void Write(const std::string& name, vtkUnstructuredGrid* grid)
  {
    std::filesystem::create_directories((Folder / name).parent_path());
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetFileName((Folder / name).c_str());
    ASSERT_EQ(writer->Write(), 1);
  }
  std::string WriteText(const std::string& name, const std::string& text)
  {
    std::filesystem::create_directories((Folder / name).parent_path());
    std::ofstream(Folder / name) << text;
    return Folder / name;
  }
  std::string WriteCollection(const std::string& dataSets)
  {
    return WriteText("series.pvd",
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" +
        dataSets + "</Collection>\n</VTKFile>\n");
  }
  void WritePieces(const std::string& name, const std::vector<std::string>& sources)
  {
    std::string text = "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid GhostLevel=\"0\">\n";
    for (const auto& source : sources)
    {
      text += "<Piece Source=\"" + source + "\"/>\n";
    }
    WriteText(name, text + "</PUnstructuredGrid></VTKFile>\n");
  }
  static std::string DataSet(const std::string& attributes, const std::string& file)
  {
    return "<DataSet " + attributes + " file=\"" + file + "\"/>\n";
  }

  /// The probe's values at time `t` are those of the closed form at `expected`.
  void ExpectValues(double t, double expected, int points = 3)
  {
    Probe->UpdateTimeStep(t);
    ASSERT_EQ(Heard->errors, "");
    auto* out = vtkPolyData::SafeDownCast(Probe->GetOutputDataObject(0));
    vtkDataArray* u = out->GetPointData()->GetArray("u");
    ASSERT_NE(u, nullptr);
    for (int i = 0; i < points; ++i)
    {
      double x[3];
      out->GetPoint(i, x);
      EXPECT_EQ(out->GetPointData()->GetArray("Verdict")->GetComponent(i, 0), 1.0) << i;
      EXPECT_NEAR(u->GetComponent(i, 0), Exact({ x[0], x[1], x[2] }, expected), 1e-13) << t;
    }
  }
  const Locator* Located()
  {
    const auto model = HighOrderModel::From(Converter->GetHighOrderOutput());
    return model->HasLocator() ? &model->GetLocator() : nullptr;
  }
  std::vector<double> Steps()
  {
    Reader->UpdateInformation();
    vtkInformation* out = Reader->GetOutputInformation(0);
    if (!out->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
    {
      return {};
    }
    const double* steps = out->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    const double* range = out->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
    EXPECT_EQ(range[0], steps[0]);
    EXPECT_EQ(range[1], steps[out->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) - 1]);
    return { steps, steps + out->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) };
  }
  void ExpectError(const std::string& word)
  {
    Heard->errors.clear();
    Reader->Modified();
    Reader->Update();
    EXPECT_NE(Heard->errors.find(word), std::string::npos) << word << ": " << Heard->errors;
    EXPECT_EQ(
      vtkUnstructuredGrid::SafeDownCast(Reader->GetOutputDataObject(0))->GetNumberOfCells(), 0);
  }
};
} // namespace pixelexact::testing
