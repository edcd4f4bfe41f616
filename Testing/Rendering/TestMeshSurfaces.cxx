// SPDX-License-Identifier: BSD-3-Clause
// Cut-surfaces that are made of the mesh: what they select, and what is refused.
#include "CutScene.h"

#include "vtkHighOrderBoundarySurface.h"
#include "vtkHighOrderIsoSurface.h"

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
  ExpectError("no high-order field 'w'");
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
  ExpectError("not available yet");
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
  ExpectError("not available yet");
  boundary->AddElement(1008);
  ExpectError("no element 1008; its elements are numbered from 1000 to 1007");
  boundary->SelectAll();
  EXPECT_EQ(boundary->GetNumberOfElements(), 0);
  EXPECT_EQ(boundary->GetNumberOfAttributes(), 0);
  ExpectError("not available yet");
}
} // namespace pixelexact
