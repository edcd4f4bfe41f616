// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderComparison: linear surfaces of known errors, convergence, wrong use.
#include "BoxGrid.h"

#include "vtkHighOrderComparison.h"
#include "vtkHighOrderGrid.h"
#include "vtkHighOrderLinearCut.h"
#include "vtkHighOrderSubdivide.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkCutter.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkTestErrorObserver.h"
#include "vtkTrivialProducer.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace pixelexact::testing
{
namespace
{
vtkSmartPointer<vtkUnstructuredGrid> Toroid()
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(PIXELEXACT_DATA_DIR "/toroid_hex_g3_p6.vtu");
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputConnection(reader->GetOutputPort());
  convert->Update();
  return convert->GetHighOrderOutput();
}

struct Comparing
{
  vtkNew<vtkHighOrderComparison> filter;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkCamera> camera;
  vtkNew<vtkTest::ErrorObserver> messages;

  explicit Comparing(vtkUnstructuredGrid* grid)
  {
    double bounds[6];
    grid->GetBounds(bounds);
    const double x = (bounds[0] + bounds[1]) / 2.0;
    const double y = (bounds[2] + bounds[3]) / 2.0;
    plane->SetOrigin(x, y, 0.1);
    plane->SetNormal(0.0, 0.0, 1.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.55 * (bounds[3] - bounds[2]));
    camera->SetFocalPoint(x, y, 0.0);
    camera->SetPosition(x, y, 10.0);
    filter->AddObserver(vtkCommand::ErrorEvent, messages);
    filter->SetInputDataObject(0, grid);
    filter->SetCutFunction(plane);
    filter->SetCamera(camera);
    filter->SetSize(120, 100);
  }
  double At(int row, const char* column)
  {
    filter->Update();
    return filter->GetOutput()->GetValueByName(row, column).ToDouble();
  }
};

TEST(Comparison, TellsErrorsOfKnownSize)
{
  const auto grid = BoxGrid(2);
  Comparing comparing(grid);
  comparing.filter->SetFieldName("u");
  // The triangles' values differ from the field by 0.25.
  vtkNew<vtkHighOrderLinearCut> cut;
  cut->SetInputData(grid);
  cut->SetCutFunction(comparing.plane);
  cut->SetResolution(64);
  cut->Update();
  vtkNew<vtkPolyData> wrong;
  wrong->DeepCopy(cut->GetOutput());
  vtkDataArray* u = wrong->GetPointData()->GetArray("u");
  for (vtkIdType i = 0; i < u->GetNumberOfTuples(); ++i)
  {
    u->SetComponent(i, 0, u->GetComponent(i, 0) + 0.25);
  }
  vtkNew<vtkPolyData> nothing;
  comparing.filter->AddSurfaceConnection(cut->GetOutputPort());
  for (vtkPolyData* data : { wrong.Get(), nothing.Get() })
  {
    vtkNew<vtkTrivialProducer> source;
    source->SetOutput(data);
    comparing.filter->AddSurfaceConnection(source->GetOutputPort());
  }
  EXPECT_GT(comparing.At(0, "Shown"), 1000.0);
  ASSERT_EQ(comparing.filter->GetOutput()->GetNumberOfRows(), 3);
  EXPECT_EQ(comparing.At(0, "Missing"), 0.0);
  EXPECT_EQ(comparing.At(0, "Invented"), 0.0);
  EXPECT_LT(comparing.At(0, "LargestError"), 1e-2);
  // Relative to the field's range on the square, 2 except for the half pixels at its edge.
  EXPECT_NEAR(comparing.At(1, "MeanError"), 0.25 / 2.0, 0.01);
  EXPECT_NEAR(comparing.At(1, "LargestError"), 0.25 / 2.0, 0.015);
  EXPECT_EQ(comparing.At(2, "Triangles"), 0.0);
  EXPECT_EQ(comparing.At(2, "Missing"), comparing.At(0, "Shown"));
  EXPECT_TRUE(std::isinf(comparing.At(2, "ErrorAtShare")));
}

TEST(Comparison, WithoutACameraAllIsSeenFromThePlanesNormal)
{
  const auto grid = BoxGrid(2);
  Comparing comparing(grid);
  comparing.filter->SetCamera(nullptr);
  vtkNew<vtkHighOrderLinearCut> cut;
  cut->SetInputData(grid);
  cut->SetCutFunction(comparing.plane);
  comparing.filter->AddSurfaceConnection(cut->GetOutputPort());
  // The square is as long as the image is high, but for a sphere's room about the box.
  EXPECT_GT(comparing.At(0, "Shown"), 0.2 * 100 * 100);
  EXPECT_LT(comparing.At(0, "Shown"), 100 * 100);
  EXPECT_EQ(comparing.At(0, "Missing"), 0.0);
}

TEST(Comparison, LinearSurfacesConvergeAtSecondOrder)
{
  const auto grid = Toroid();
  Comparing comparing(grid);
  comparing.filter->GenerateContourValues(5, -0.5, 0.5);
  for (const int resolution : { 64, 128, 256 })
  {
    vtkNew<vtkHighOrderLinearCut> cut;
    cut->SetInputData(grid);
    cut->SetCutFunction(comparing.plane);
    cut->SetResolution(resolution);
    comparing.filter->AddSurfaceConnection(cut->GetOutputPort());
  }
  for (const int level : { 2, 3 })
  {
    vtkNew<vtkHighOrderSubdivide> subdivide;
    subdivide->SetInputData(grid);
    subdivide->SetLevel(level);
    vtkNew<vtkCutter> cutter;
    cutter->SetInputConnection(subdivide->GetOutputPort());
    cutter->SetCutFunction(comparing.plane);
    comparing.filter->AddSurfaceConnection(cutter->GetOutputPort());
  }
  const auto order = [&](int coarse, int fine)
  { return std::log2(comparing.At(coarse, "MeanError") / comparing.At(fine, "MeanError")); };
  EXPECT_NEAR(order(0, 1), 2.0, 0.1);
  EXPECT_NEAR(order(1, 2), 2.0, 0.1);
  EXPECT_NEAR(order(3, 4), 2.0, 0.2);
  EXPECT_GT(comparing.At(0, "ContourPixels"), 100.0);
  EXPECT_GE(comparing.At(0, "ContourDisplaced"), comparing.At(2, "ContourDisplaced"));
  // Near extrema that just reach a value there may be a pixel more or less.
  EXPECT_LT(comparing.At(2, "ContourMissed"), 0.01 * comparing.At(2, "ContourPixels"));
  EXPECT_LT(comparing.At(2, "ContourInvented"), 0.01 * comparing.At(2, "ContourPixels"));
}

TEST(Comparison, WrongUseIsNamedAndAbortsLeaveNothing)
{
  const auto grid = BoxGrid(2);
  const auto refused = [](Comparing& comparing, const std::string& text)
  {
    comparing.messages->Clear();
    comparing.filter->Update();
    EXPECT_NE(comparing.messages->GetErrorMessage().find(text), std::string::npos)
      << comparing.messages->GetErrorMessage();
    EXPECT_EQ(comparing.filter->GetOutput()->GetNumberOfRows(), 0);
  };
  vtkNew<vtkPlaneSource> square; // without the field
  Comparing field(grid);
  field.filter->AddSurfaceConnection(square->GetOutputPort());
  refused(field, "has no point array 'u'");
  field.filter->SetFieldName("no such");
  refused(field, "no such");
  field.filter->SetFieldName("");
  field.filter->SetCutFunction(nullptr);
  refused(field, "SetCutFunction");

  struct Abort : vtkCommand
  {
    static Abort* New() { return new Abort; }
    void Execute(vtkObject* caller, unsigned long /*event*/, void* /*data*/) override
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  };
  Comparing aborted(grid);
  vtkNew<vtkHighOrderLinearCut> cut;
  cut->SetInputData(grid);
  cut->SetCutFunction(aborted.plane);
  aborted.filter->AddSurfaceConnection(cut->GetOutputPort());
  vtkNew<Abort> abort;
  aborted.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  aborted.filter->Update();
  EXPECT_EQ(aborted.filter->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_FALSE(aborted.messages->GetError());
}
} // namespace
} // namespace pixelexact::testing
