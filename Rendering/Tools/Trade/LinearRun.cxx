// SPDX-License-Identifier: BSD-3-Clause
// Builds each linear pipeline as users would.
#include "Base/PeakMemory.h"
#include "Base/VtkMessages.h"
#include "Bench/FrameTime.h"
#include "Scene/Shot.h"
#include "Trade/LinearContours.h"
#include "Trade/NodalExpression.h"
#include "Trade/TradeRun.h"

#include "Core/Base/Error.h"
#include "Core/Expression/Expression.h"
#include "HighOrderModel.h"
#include "Surfaces/VtkLinearSurface.h"
#include "Trace/Compare/TracedPicture.h"

#include <fmt/format.h>
#include <vtkArrayCalculator.h>
#include <vtkCell.h>
#include <vtkContourFilter.h>
#include <vtkCutter.h>
#include <vtkDoubleArray.h>
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
#include <map>
#include <set>

namespace pixelexact
{
namespace
{
/// A pipeline whose output are polygons with the field at their corners.
struct Pipes
{
  vtkSmartPointer<vtkAlgorithm> cut;    ///< the last one
  vtkSmartPointer<vtkAlgorithm> volume; ///< source of its cells; null: it cuts the grid itself
};

/// Name of the array with a component or magnitude, because VTK's contour filter supports scalars
/// only.
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

/// The names of the field and of the iso-surface's field.
std::set<std::string> NamesOfArrays(const TradeScene& scene)
{
  std::set<std::string> names{ scene.shot->scene.layers.front().field->name };
  if (!scene.isoField.empty())
  {
    names.insert(scene.isoField);
  }
  return names;
}

/// The arrays among NamesOfArrays that are expressions with derivatives.
std::map<std::string, NodalExpression> ArraysWithDerivatives(const TradeScene& scene)
{
  std::map<std::string, NodalExpression> found;
  for (const std::string& name : NamesOfArrays(scene))
  {
    const Field* const field = scene.shot->input.model->FindField(name);
    if (field == nullptr)
    {
      continue;
    }
    const auto* expression = dynamic_cast<const FieldExpression*>(field->function.get());
    if (expression != nullptr && NodalExpression(*expression).HasDerivatives())
    {
      found.emplace(name, *expression);
    }
  }
  return found;
}

/// The names of the point data that a family's filters need.
std::set<std::string> NamesOfPointData(const TradeScene& scene, TradeFamily family)
{
  std::set<std::string> names = NamesOfArrays(scene);
  if (IsOfGradientFilter(family))
  {
    for (const auto& [name, expression] : ArraysWithDerivatives(scene))
    {
      names.erase(name);
      for (const std::string& field : expression.FieldNames())
      {
        names.insert(field);
      }
    }
  }
  return names;
}

vtkSmartPointer<vtkHighOrderSubdivide> NewSubdivide(
  const TradeScene& scene, const TradeSetting& setting, vtkUnstructuredGrid* grid)
{
  auto subdivide = vtkSmartPointer<vtkHighOrderSubdivide>::New();
  subdivide->SetInputData(grid);
  subdivide->SetLevel(setting.number);
  for (const std::string& name : NamesOfPointData(scene, setting.family))
  {
    subdivide->AddField(name);
  }
  return subdivide;
}

/// A grid's cells with the arrays that are cut, derivatives by VTK's Gradient filter.
vtkSmartPointer<vtkUnstructuredGrid> WithFilteredDerivatives(
  const TradeScene& scene, vtkUnstructuredGrid* grid)
{
  const std::map<std::string, NodalExpression> expressions = ArraysWithDerivatives(scene);
  auto output = vtkSmartPointer<vtkUnstructuredGrid>::New();
  output->CopyStructure(grid);
  for (const std::string& name : NamesOfArrays(scene))
  {
    if (const auto found = expressions.find(name); found != expressions.end())
    {
      const auto values = found->second.Compute(grid);
      values->SetName(name.c_str());
      output->GetPointData()->AddArray(values);
    }
    else
    {
      output->GetPointData()->AddArray(grid->GetPointData()->GetArray(name.c_str()));
    }
  }
  return output;
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
  if (IsOfGradientFilter(setting.family))
  {
    vtkSmartPointer<vtkHighOrderSubdivide> subdivide;
    if (setting.family == TradeFamily::Gradient)
    {
      subdivide = NewSubdivide(scene, setting, grid);
      subdivide->Update();
      grid = subdivide->GetOutput();
    }
    // Without points, VTK's own messages state the reason.
    first->SetInputDataObject(
      grid->GetNumberOfPoints() > 0 ? WithFilteredDerivatives(scene, grid).Get() : grid);
    return { cutter, subdivide };
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
    volume = NewSubdivide(scene, setting, grid);
  }
  first->SetInputConnection(volume->GetOutputPort());
  return { cutter, volume };
}

class LinearRun final : public TradeRun
{
public:
  LinearRun(const TradeScene& scene, const TradeSetting& setting)
    : scene_(scene)
    , Setting(setting)
  {
  }

  TradeTime Measure() override
  {
    const FreshModel fresh(*scene_.shot);
    const VtkMessages messages;
    TradeTime time;
    const PeakMemory memory;
    const Timer first;
    const Pipes pipes = MakePipes(scene_, Setting, fresh.grid);
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
    const Layer& layer = scene_.shot->scene.layers.front();
    const auto linear = ToLinearSurface(Surface, layer.field->name, layer.component);
    Count = linear->Count();
    return TracePicture(*linear, scene_.shot->MakeCamera(), scene_.isoValues);
  }

  [[nodiscard]] std::size_t Triangles() const override { return Count; }

private:
  void Run(const Pipes& pipes)
  {
    pipes.cut->Update();
    if (!scene_.isoValues.empty())
    {
      MakeContours(vtkPolyData::SafeDownCast(pipes.cut->GetOutputDataObject(0)));
    }
  }

  void MakeContours(vtkPolyData* surface)
  {
    if (const auto contours =
          MakeLinearContours(surface, scene_.shot->scene.layers.front(), scene_.isoValues))
    {
      contours->Update();
    }
  }

  const TradeScene& scene_;
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

bool HasDerivatives(const TradeScene& scene)
{
  return !ArraysWithDerivatives(scene).empty();
}

std::string GradientObstacle(const TradeScene& scene)
{
  if (IsOfFaces(scene) || IsOfPieces(scene))
  {
    return "VTK's Gradient filter is measured on cuts by functions and on iso-surfaces alone";
  }
  try
  {
    for (const auto& [name, expression] : ArraysWithDerivatives(scene))
    {
      expression.RequireNodal();
    }
  }
  catch (const Unsupported& error)
  {
    return error.what();
  }
  return {};
}

bool HasHighOrderCells(const TradeScene& scene, TradeFamily family)
{
  vtkUnstructuredGrid* grid = scene.shot->input.grid;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (!grid->GetCell(i)->IsLinear())
    {
      return std::ranges::all_of(NamesOfPointData(scene, family),
        [grid](const std::string& name)
        { return grid->GetPointData()->HasArray(name.c_str()) != 0; });
    }
  }
  return false;
}

std::unique_ptr<TradeRun> MakeLinearRun(const TradeScene& scene, const TradeSetting& setting)
{
  return std::make_unique<LinearRun>(scene, setting);
}
} // namespace pixelexact
