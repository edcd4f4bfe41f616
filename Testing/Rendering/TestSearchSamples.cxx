// SPDX-License-Identifier: BSD-3-Clause
// Functions without a closed form in windows: the search for their hits, and its warnings.
#include "CutScene.h"

#include "vtkHighOrderLayer.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::ErrorObserver;

/// z^2 - Half^2: two planes.
class Slab : public vtkImplicitFunction
{
public:
  static Slab* New();
  vtkTypeMacro(Slab, vtkImplicitFunction);
  vtkSetMacro(Half, double);
  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override { return x[2] * x[2] - Half * Half; }
  void EvaluateGradient(double x[3], double gradient[3]) override
  {
    gradient[0] = gradient[1] = 0.0;
    gradient[2] = 2.0 * x[2];
  }

private:
  double Half = 0.002;
};
vtkStandardNewMacro(Slab);

vtkIdType PixelsShown(vtkHighOrderMapper* mapper)
{
  vtkDataArray* verdicts = mapper->GetBuffers()->GetPointData()->GetArray("Verdict");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < verdicts->GetNumberOfTuples(); ++i)
  {
    count += verdicts->GetComponent(i, 0) == 1.0 ? 1 : 0;
  }
  return count;
}
} // namespace

TEST(SearchSamples, ThinSheetsAreFoundByMoreOfThem)
{
  CutScene scene;
  testing::Window window;
  window.Renderer->AddActor(scene.Cut);
  CutScene::Look(window.Renderer, false);
  EXPECT_EQ(scene.Mapper->GetNumberOfNumericHits(), 0);
  window.Render();
  // The plane between the two.
  const vtkIdType plane = PixelsShown(scene.Mapper);
  EXPECT_EQ(scene.Mapper->GetNumberOfNumericHits(), 0);
  vtkNew<Slab> slab;
  scene.Mapper->SetCutFunction(slab);
  EXPECT_EQ(scene.Mapper->GetSearchSamples(), 128);
  window.Render();
  EXPECT_LT(PixelsShown(scene.Mapper), plane * 9 / 10);
  EXPECT_EQ(scene.Mapper->GetNumberOfNumericHits(), PixelsShown(scene.Mapper));
  const vtkIdType traces = scene.Mapper->GetNumberOfTraces();
  scene.Mapper->SetSearchSamples(2000);
  window.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), traces + 1);
  // The counts agree up to the rim, where rays meet the box outside of the plane.
  EXPECT_NEAR(
    static_cast<double>(PixelsShown(scene.Mapper)), static_cast<double>(plane), 0.02 * plane);
  EXPECT_EQ(scene.Mapper->GetNumberOfNumericHits(), PixelsShown(scene.Mapper));
  vtkNew<vtkHighOrderMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  EXPECT_EQ(copy->GetSearchSamples(), 2000);
  copy->SetSearchSamples(1);
  EXPECT_EQ(copy->GetSearchSamples(), 2);
}

/// A class derived from vtkPlane may be any function, with further hits behind the first.
TEST(SearchSamples, FunctionsDerivedFromPlanesAreSeenThrough)
{
  class TwoPlanes : public vtkPlane
  {
  public:
    static TwoPlanes* New()
    {
      auto* made = new TwoPlanes;
      made->InitializeObjectBase();
      return made;
    }
    vtkTypeMacro(TwoPlanes, vtkPlane);
    using vtkPlane::EvaluateFunction;
    double EvaluateFunction(double x[3]) override { return x[2] * x[2] - 0.01; }
    void EvaluateFunction(vtkDataArray* input, vtkDataArray* output) override
    {
      for (vtkIdType i = 0; i < input->GetNumberOfTuples(); ++i)
      {
        double x[3];
        input->GetTuple(i, x);
        output->SetComponent(i, 0, this->EvaluateFunction(x));
      }
    }
  };
  CutScene scene;
  testing::Window window;
  window.Renderer->AddActor(scene.Cut);
  CutScene::Look(window.Renderer, false);
  vtkNew<TwoPlanes> planes;
  scene.Mapper->SetCutFunction(planes);
  scene.Cut->GetProperty()->SetOpacity(0.5);
  window.Render();
  EXPECT_GT(PixelsShown(scene.Mapper), 10000);
  EXPECT_GT(scene.Mapper->GetNumberOfNumericHits(), PixelsShown(scene.Mapper) * 5 / 4);
}

/// Hits behind the largest number of sheets are reported, as by the tool.
TEST(SearchSamples, MoreSheetsThanAreKeptAreTold)
{
  CutScene scene;
  vtkNew<ErrorObserver> warnings;
  scene.Mapper->AddObserver(vtkCommand::WarningEvent, warnings);
  testing::Window window;
  window.Renderer->AddActor(scene.Cut);
  CutScene::Look(window.Renderer, false);
  for (int k = 0; k < 70; ++k)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, 0.0, 0.01 * k);
    vtkNew<vtkHighOrderLayer> layer;
    layer->SetCutFunction(plane);
    layer->SetOpacity(0.01);
    scene.Mapper->AddLayer(layer);
    if (k == 60)
    {
      window.Render();
      EXPECT_EQ(warnings->Text, "");
    }
  }
  window.Render();
  EXPECT_NE(warnings->Text.find("more than 64 translucent surfaces"), std::string::npos)
    << warnings->Text;
}
} // namespace pixelexact
