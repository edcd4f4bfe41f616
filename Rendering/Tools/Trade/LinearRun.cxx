// SPDX-License-Identifier: BSD-3-Clause
// Each linear pipeline as its users build it.
#include "Base/PeakMemory.h"
#include "Base/VtkMessages.h"
#include "Bench/FrameTime.h"
#include "Scene/Shot.h"
#include "Trade/LinearContours.h"
#include "Trade/TradeRun.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"
#include "Surfaces/VtkLinearSurface.h"
#include "Trace/Compare/TracedPicture.h"

#include <fmt/format.h>
#include <vtkArrayCalculator.h>
#include <vtkCell.h>
#include <vtkContourFilter.h>
#include <vtkCutter.h>
#include <vtkHighOrderLinearCut.h>
#include <vtkHighOrderLinearResample.h>
#include <vtkHighOrderSubdivide.h>
#include <vtkImplicitFunction.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// A pipeline that leaves polygons with the field at their corners.
struct Pipes
{
  vtkSmartPointer<vtkAlgorithm> cut;    ///< the last one
  vtkSmartPointer<vtkAlgorithm> volume; ///< that it gets its cells from; null: it cuts the field
};

/// Of fields with several components, whose contours VTK's filter does not know.
constexpr const char* kIsoScalar = "PixelExact.IsoScalar";

/// Null where the contoured array is that of the field.
vtkSmartPointer<vtkAlgorithm> NewIsoScalar(const TradeScene& scene)
{
  if (scene.function || scene.isoComponents == 1)
  {
    return nullptr;
  }
  auto calculator = vtkSmartPointer<vtkArrayCalculator>::New();
  calculator->SetAttributeTypeToPointData();
  calculator->SetResultArrayName(kIsoScalar);
  std::string squares;
  for (int c = 0; c < scene.isoComponents; ++c)
  {
    const std::string name = fmt::format("s{}", c);
    calculator->AddScalarVariable(name.c_str(), scene.isoField.c_str(), c);
    squares += fmt::format("{0}{1}*{1}", c > 0 ? "+" : "", name);
  }
  const std::string function = scene.isoComponent == kMagnitude
    ? "sqrt(" + squares + ")"
    : fmt::format("s{}", scene.isoComponent);
  calculator->SetFunction(function.c_str());
  return calculator;
}

vtkSmartPointer<vtkAlgorithm> NewCutter(const TradeScene& scene)
{
  if (!scene.function)
  {
    auto contour = vtkSmartPointer<vtkContourFilter>::New();
    contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
      scene.isoComponents == 1 ? scene.isoField.c_str() : kIsoScalar);
    contour->SetValue(0, scene.isoValue);
    contour->ComputeNormalsOff();
    return contour;
  }
  auto cutter = vtkSmartPointer<vtkCutter>::New();
  cutter->SetCutFunction(scene.function);
  cutter->GenerateTrianglesOn();
  return cutter;
}

Pipes MakePipes(const TradeScene& scene, const TradeSetting& setting, vtkUnstructuredGrid* grid)
{
  const std::string& field = scene.shot->scene.layers.front().field->name;
  if (setting.family == TradeFamily::Cut)
  {
    auto cut = vtkSmartPointer<vtkHighOrderLinearCut>::New();
    cut->SetInputData(grid);
    cut->SetCutFunction(scene.function);
    cut->SetResolution(setting.number);
    cut->AddField(field);
    return { cut, nullptr };
  }
  const vtkSmartPointer<vtkAlgorithm> cutter = NewCutter(scene);
  const vtkSmartPointer<vtkAlgorithm> scalar = NewIsoScalar(scene);
  vtkAlgorithm* first = scalar ? scalar.Get() : cutter.Get();
  if (scalar)
  {
    cutter->SetInputConnection(scalar->GetOutputPort());
  }
  if (setting.family == TradeFamily::Cells)
  {
    first->SetInputDataObject(grid);
    return { cutter, nullptr };
  }
  vtkSmartPointer<vtkAlgorithm> volume;
  if (setting.family == TradeFamily::Resample)
  {
    auto resample = vtkSmartPointer<vtkHighOrderLinearResample>::New();
    resample->SetInputData(grid);
    resample->SetDimensions(NodesAlong(grid, setting.number).data());
    resample->AddField(field);
    volume = resample;
  }
  else
  {
    auto subdivide = vtkSmartPointer<vtkHighOrderSubdivide>::New();
    subdivide->SetInputData(grid);
    subdivide->SetLevel(setting.number);
    subdivide->AddField(field);
    if (!scene.isoField.empty() && scene.isoField != field)
    {
      subdivide->AddField(scene.isoField);
    }
    volume = subdivide;
  }
  first->SetInputConnection(volume->GetOutputPort());
  return { cutter, volume };
}

class LinearRun final : public TradeRun
{
public:
  LinearRun(const TradeScene& scene, const TradeSetting& setting)
    : TheScene(scene)
    , Setting(setting)
  {
  }

  TradeTime Measure() override
  {
    const FreshModel fresh(*TheScene.shot);
    const VtkMessages messages;
    TradeTime time;
    const PeakMemory memory;
    const Timer first;
    const Pipes pipes = MakePipes(TheScene, Setting, fresh.grid);
    Run(pipes);
    time.first = first.Seconds();
    if (messages.FirstError().empty())
    {
      const Timer next;
      pipes.cut->Modified();
      Run(pipes);
      time.next = next.Seconds();
    }
    time.bytes = memory.Bytes().value_or(-1.0);
    if (const std::string error = messages.FirstError(); !error.empty())
    {
      throw Error(error);
    }
    Surface = vtkSmartPointer<vtkPolyData>::New();
    Surface->ShallowCopy(pipes.cut->GetOutputDataObject(0));
    return time;
  }

  Picture Show() override
  {
    const Layer& layer = TheScene.shot->scene.layers.front();
    const auto linear = ToLinearSurface(Surface, layer.field->name, layer.component);
    Count = linear->Count();
    return TracePicture(*linear, TheScene.shot->MakeCamera(), TheScene.isoValues);
  }

  [[nodiscard]] std::size_t Triangles() const override { return Count; }

private:
  void Run(const Pipes& pipes)
  {
    pipes.cut->Update();
    if (!TheScene.isoValues.empty())
    {
      MakeContours(vtkPolyData::SafeDownCast(pipes.cut->GetOutputDataObject(0)));
    }
  }

  void MakeContours(vtkPolyData* surface)
  {
    if (const auto contours =
          MakeLinearContours(surface, TheScene.shot->scene.layers.front(), TheScene.isoValues))
    {
      contours->Update();
    }
  }

  const TradeScene& TheScene;
  TradeSetting Setting;
  vtkSmartPointer<vtkPolyData> Surface;
  std::size_t Count = 0;
};
} // namespace

std::array<int, 3> NodesAlong(vtkUnstructuredGrid* grid, int number)
{
  double bounds[6];
  grid->GetBounds(bounds);
  const double sides[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
  const double spacing = *std::max_element(sides, sides + 3) / (number - 1);
  std::array<int, 3> nodes{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    nodes[d] = 1 + std::max(1, static_cast<int>(std::ceil(sides[d] / spacing - 1e-9)));
  }
  return nodes;
}

bool HasHighOrderCells(const TradeScene& scene)
{
  vtkUnstructuredGrid* grid = scene.shot->input.grid;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (!grid->GetCell(i)->IsLinear())
    {
      const auto has = [grid](const std::string& name)
      { return grid->GetPointData()->HasArray(name.c_str()) != 0; };
      return has(scene.shot->scene.layers.front().field->name) &&
        (scene.isoField.empty() || has(scene.isoField));
    }
  }
  return false;
}

std::unique_ptr<TradeRun> MakeLinearRun(const TradeScene& scene, const TradeSetting& setting)
{
  return std::make_unique<LinearRun>(scene, setting);
}
} // namespace pixelexact
