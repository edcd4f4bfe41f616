// SPDX-License-Identifier: BSD-3-Clause
// Cut-surfaces that are made of the mesh: what they select, and what is refused.
#include "CutScene.h"

#include "vtkHighOrderBoundarySurface.h"
#include "vtkHighOrderIsoSurface.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::ErrorObserver;

/// Renders and returns what the mapper complained of.
class MeshSurfaces : public ::testing::Test
{
protected:
  MeshSurfaces()
  {
    Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, Errors);
    Window.Renderer->AddActor(Scene.Cut);
    CutScene::Look(Window.Renderer, false);
  }

  void ExpectError(const char* part)
  {
    Errors->Text.clear();
    Window.Render();
    EXPECT_NE(Errors->Text.find(part), std::string::npos) << part << ": " << Errors->Text;
    EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  }

  /// Renders without a complaint, and returns where the exact pixels' positions are.
  std::vector<Vec3> ExpectPicture()
  {
    Errors->Text.clear();
    Window.Render();
    EXPECT_EQ(Errors->Text, "");
    std::vector<Vec3> positions;
    vtkImageData* buffers = Scene.Mapper->GetBuffers();
    if (buffers == nullptr)
    {
      ADD_FAILURE() << "no picture";
      return positions;
    }
    vtkDataArray* verdicts = buffers->GetPointData()->GetArray("Verdict");
    vtkDataArray* array = buffers->GetPointData()->GetArray("Position");
    for (vtkIdType i = 0; i < verdicts->GetNumberOfTuples(); ++i)
    {
      EXPECT_NE(verdicts->GetTuple1(i), 2.0);
      if (verdicts->GetTuple1(i) == 1.0)
      {
        const double* x = array->GetTuple3(i);
        positions.emplace_back(x[0], x[1], x[2]);
      }
    }
    EXPECT_GT(positions.size(), 500U);
    return positions;
  }

  CutScene Scene;
  testing::Window Window;
  vtkNew<ErrorObserver> Errors;
};
} // namespace

TEST_F(MeshSurfaces, IsoSurfacesOfWhatIsNotThereAreRefused)
{
  vtkNew<vtkHighOrderIsoSurface> iso;
  Scene.Mapper->SetSurface(iso);
  iso->SetFieldName("w");
  ExpectError("no field 'w'");
  iso->SetFieldName("v");
  iso->SetComponent(3);
  ExpectError("component 3 is asked for");
  iso->SetComponent(vtkHighOrderIsoSurface::MAGNITUDE);
  iso->SetValue(-0.5);
  ExpectError("the magnitude of field 'v' has values from ");
  iso->SetFieldName(nullptr);
  // x^3 - x / 2 + y^2 + z / 4 over the cube is at most 1.75.
  iso->SetValue(1.76);
  ExpectError("field 'u' has values from ");
  iso->SetValue(std::numeric_limits<double>::quiet_NaN());
  ExpectError("not finite");
  iso->SetValue(0.1);
  ExpectPicture();
}

TEST_F(MeshSurfaces, TheRangeOfTheCutIsWiderThanRounding)
{
  // An iso-surface of its own field has one value; with rounding, a narrow range.
  vtkNew<vtkHighOrderIsoSurface> iso;
  iso->SetValue(0.1);
  Scene.Mapper->SetSurface(iso);
  Scene.Mapper->SetRangeModeToCut();
  Scene.Cut->GetProperty()->LightingOff();
  ExpectPicture();
  const double* range = Scene.Mapper->GetScalarRange();
  EXPECT_LT(range[0], 0.1 - 1e-8);
  EXPECT_GT(range[1], 0.1 + 1e-8);
  vtkDataArray* colors = Scene.Mapper->GetBuffers()->GetPointData()->GetArray("Color");
  vtkDataArray* verdicts = Scene.Mapper->GetBuffers()->GetPointData()->GetArray("Verdict");
  std::set<double> seen;
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    if (verdicts->GetTuple1(i) == 1.0)
    {
      seen.insert(colors->GetComponent(i, 0));
    }
  }
  EXPECT_EQ(seen.size(), 1U);
}

TEST_F(MeshSurfaces, ClippingPlanesOpenTheBoundary)
{
  // The field's box is [-1, 1]^3, seen from above and from the side y < 0.
  vtkNew<vtkHighOrderBoundarySurface> boundary;
  Scene.Mapper->SetSurface(boundary);
  bool isTop = false;
  for (const Vec3& x : ExpectPicture())
  {
    EXPECT_NEAR(std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) }), 1.0, 1e-13);
    EXPECT_TRUE(x.y < -1.0 + 1e-13 || x.z > 1.0 - 1e-13 || x.x > 1.0 - 1e-13);
    isTop = isTop || x.z > 1.0 - 1e-13;
  }
  EXPECT_TRUE(isTop);
  vtkNew<vtkPlane> below;
  below->SetOrigin(0.0, 0.0, 0.25);
  below->SetNormal(0.0, 0.0, -1.0);
  Scene.Mapper->AddClippingPlane(below);
  bool isBottom = false;
  for (const Vec3& x : ExpectPicture())
  {
    EXPECT_NEAR(std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) }), 1.0, 1e-13);
    EXPECT_LE(x.z, 0.25 + 1e-13);
    isBottom = isBottom || x.z < -1.0 + 1e-13;
  }
  EXPECT_TRUE(isBottom);
}

TEST_F(MeshSurfaces, BoundariesAddUpWhatIsSelected)
{
  vtkNew<vtkHighOrderBoundarySurface> boundary;
  Scene.Mapper->SetSurface(boundary);
  const vtkMTimeType before = boundary->GetMTime();
  boundary->SelectAll();
  EXPECT_EQ(boundary->GetMTime(), before);
  boundary->AddAttribute(3);
  boundary->AddElement(1007);
  EXPECT_GT(boundary->GetMTime(), before);
  EXPECT_EQ(boundary->GetNumberOfAttributes(), 1);
  EXPECT_EQ(boundary->GetAttribute(0), 3);
  EXPECT_EQ(boundary->GetAttribute(1), -1);
  EXPECT_EQ(boundary->GetNumberOfElements(), 1);
  EXPECT_EQ(boundary->GetElement(0), 1007);
  ExpectError("there is no boundary attribute 3");
  boundary->AddElement(1008);
  ExpectError("no element 1008; its elements are numbered from 1000 to 1007");
  boundary->SelectAll();
  EXPECT_EQ(boundary->GetNumberOfElements(), 0);
  EXPECT_EQ(boundary->GetNumberOfAttributes(), 0);
  ExpectPicture();
}
} // namespace pixelexact
