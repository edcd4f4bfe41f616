// SPDX-License-Identifier: BSD-3-Clause
// Figures 9 and 11 of the paper in numbers.
#include "Base/PeakMemory.h"
#include "Base/VtkMessages.h"
#include "Bench/FrameTime.h"
#include "Scene/ColorOptions.h"
#include "Scene/Shot.h"
#include "Trade/LinearContours.h"
#include "Trade/PaperRuns.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"
#include "Surfaces/FunctionOfSurface.h"
#include "Surfaces/VtkLinearSurface.h"
#include "Trace/Compare/TracedPicture.h"

#include <vtkContourFilter.h>
#include <vtkHighOrderLinearCut.h>
#include <vtkImplicitFunction.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr int kComparedContours = 10;

/// The range of the finite values in a picture.
std::array<double, 2> RangeOf(const Picture& picture)
{
  std::array<double, 2> range{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (const double value : picture.value)
  {
    if (std::isfinite(value))
    {
      range = { std::min(range[0], value), std::max(range[1], value) };
    }
  }
  return range;
}

/// Measures the seconds of vtkContourFilter on the triangles.
double ContourTriangles(
  vtkPolyData* surface, const Layer& layer, const std::vector<double>& isoValues)
{
  const auto contours = MakeLinearContours(surface, layer, isoValues);
  const Timer timer;
  contours->Update();
  return timer.Seconds();
}

PaperErrors MeasureLinear(const Shot& shot, int resolution, const Picture& truth,
  const std::array<double, 2>& range, const std::vector<double>& isoValues)
{
  const Layer& layer = shot.scene.layers.front();
  const VtkMessages messages;
  PaperErrors result;
  vtkNew<vtkHighOrderLinearCut> cut;
  {
    const PeakMemory memory;
    const Timer timer;
    cut->SetInputData(shot.input.grid);
    cut->SetCutFunction(FunctionOf(*layer.surface));
    cut->SetResolution(resolution);
    cut->AddField(layer.field->name);
    cut->Update();
    result.cutSeconds = timer.Seconds();
    result.bytes = memory.Bytes().value_or(-1.0);
  }
  if (const std::string error = messages.FirstError(); !error.empty())
  {
    throw Error(error);
  }
  vtkPolyData* const surface = cut->GetOutput();
  result.contourSeconds = ContourTriangles(surface, layer, isoValues);
  const auto linear = ToLinearSurface(surface, layer.field->name, layer.component);
  result.triangles = static_cast<std::int64_t>(linear->Count());
  const Picture picture = TracePicture(*linear, shot.MakeCamera(), isoValues);
  const PictureErrors errors = Compare(truth, picture, { 0.99, range, 256 });
  const double width = range[1] - range[0];
  result.largest = width > 0.0 ? errors.largest / width : 0.0;
  result.mean = width > 0.0 ? errors.mean / width : 0.0;
  result.contourPixels = errors.contourPixels;
  result.missed = errors.contourMissed;
  result.displaced = errors.contourDisplaced;
  result.invented = errors.contourInvented;
  return result;
}
} // namespace

void MeasurePaperErrors(const Shot& shot, PaperExtent extent, PaperResults& results)
{
  const Layer& layer = shot.scene.layers.front();
  if (layer.field == nullptr)
  {
    throw Error("--paper: the input has no field; name the file of a field");
  }
  if (!layer.surface->IsPlane() || !FunctionOf(*layer.surface))
  {
    throw Error("--paper: figures 9 and 11 are of a plane; give --plane, or no surface");
  }
  const Camera camera = shot.MakeCamera();
  const Picture values = TracePicture(shot.scene, camera, {}, {}, ContourMethod());
  const std::array<double, 2> range = RangeOf(values);
  if (!(range[0] < range[1]))
  {
    throw Error("--paper: the plane shows no two values of the field; choose another one");
  }
  std::vector<double> isoValues;
  for (int k = 1; k <= kComparedContours; ++k)
  {
    isoValues.push_back(std::lerp(range[0], range[1], k / (kComparedContours + 1.0)));
  }
  const ColorMapping colors(ColorOptions().MapOver(range));
  const std::vector<const SampleColors*> colored{ &colors };
  const Timer plain;
  (void)TracePicture(shot.scene, camera, colored, {}, ContourMethod());
  results.exactSeconds = plain.Seconds();
  const Timer contoured;
  const Picture truth = TracePicture(shot.scene, camera, colored, isoValues, ContourMethod());
  results.exactContourSeconds = contoured.Seconds();
  // 2 n^2 triangles cover the whole plane: as many as in the paper if the mesh fills it.
  for (const int resolution :
    extent == PaperExtent::Whole ? std::vector{ 512, 2048 } : std::vector{ 128, 512 })
  {
    results.errors.push_back(MeasureLinear(shot, resolution, truth, range, isoValues));
  }
}
} // namespace pixelexact
