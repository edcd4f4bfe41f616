// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Model.h"

#include "Base/Processes.h"
#include "Base/Report.h"
#include "Base/VtkMessages.h"
#include "Input/Input.h"
#include "Scene/QualitySettings.h"

#include "Conversion/WarpedGrid.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "HighOrderArrays.h"
#include "vtkHighOrderCalculator.h"
#include "vtkHighOrderGrid.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <utility>

namespace pixelexact
{
namespace
{
bool HasArray(vtkUnstructuredGrid& grid, const std::string& name)
{
  return grid.GetPointData()->HasArray(name.c_str()) != 0 ||
    grid.GetCellData()->HasArray(name.c_str()) != 0;
}

/// The names of the model's fields in quotes.
std::string FieldNames(const HighOrderModel& model)
{
  std::vector<std::string> names;
  for (const Field& field : model.Fields())
  {
    names.push_back("'" + field.name + "'");
  }
  return Listed(names);
}

bool HasLagrangeWedge(vtkUnstructuredGrid& grid)
{
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    if (grid.GetCellType(cell) == VTK_LAGRANGE_WEDGE)
    {
      return true;
    }
  }
  return false;
}

void Convert(LoadedModel& input, const InputRequest& request, const std::string& field)
{
  const VtkMessages messages;
  vtkNew<vtkUnstructuredGridToHighOrderGrid> converter;
  const vtkSmartPointer<vtkUnstructuredGrid> source = input.grid;
  converter->SetInputData(source);
  converter->SetMirroredWedges(request.mirroredWedges);
  converter->SetSurfaceElements(request.surfaceElements);
  if (request.gaussLobatto)
  {
    converter->SetNodePlacementToGaussLobatto();
  }
  std::vector<std::string> fields{ field };
  if (request.warp)
  {
    fields.push_back(request.warp->field);
  }
  // A complex field needs two arrays, which the option that names it does not.
  if (!request.phase &&
    std::ranges::all_of(
      fields, [&input](const std::string& name) { return HasArray(*input.grid, name); }))
  {
    std::ranges::for_each(
      fields, [&converter](const std::string& name) { converter->AddField(name); });
  }
  ProgressLine line("converting");
  vtkNew<vtkCallbackCommand> onProgress;
  onProgress->SetClientData(&line);
  onProgress->SetCallback([](vtkObject*, unsigned long, void* client, void* part)
    { (*static_cast<ProgressLine*>(client))(*static_cast<double*>(part)); });
  converter->AddObserver(vtkCommand::ProgressEvent, onProgress);
  converter->Update();
  if (const std::string error = messages.FirstError(); !error.empty())
  {
    throw InvalidData(error);
  }
  input.grid = converter->GetHighOrderOutput();
  input.converted = true;
  input.skippedCells = converter->GetNumberOfSkippedCells();
  for (int i = 0; i < converter->GetNumberOfDiagnostics(); ++i)
  {
    input.diagnostics.push_back(converter->GetDiagnostic(i));
  }
  // A process' share may have none.
  if (request.mirroredWedges && !AreSeveralProcesses() && !HasLagrangeWedge(*source))
  {
    input.diagnostics.emplace_back(
      "--mirrored-wedges has no effect: there are no Lagrange wedges; leave it out");
  }
}

bool AreSame(vtkDataArray& a, vtkDataArray& b)
{
  return a.GetDataType() == b.GetDataType() &&
    a.GetNumberOfComponents() == b.GetNumberOfComponents() &&
    a.GetNumberOfTuples() == b.GetNumberOfTuples() && a.HasStandardMemoryLayout() &&
    b.HasStandardMemoryLayout() &&
    std::memcmp(a.GetVoidPointer(0), b.GetVoidPointer(0),
      static_cast<std::size_t>(a.GetNumberOfValues() * a.GetDataTypeSize())) == 0;
}

/// Arrays of the mesh that are the same in both become the same objects, by which a model knows
/// that it may share mesh and locator.
void ShareMesh(vtkUnstructuredGrid& before, vtkUnstructuredGrid& grid)
{
  const auto share = [](vtkFieldData& from, vtkFieldData& to)
  {
    for (int i = 0; i < from.GetNumberOfArrays(); ++i)
    {
      vtkDataArray* known = from.GetArray(i);
      const std::string name =
        known != nullptr && known->GetName() != nullptr ? known->GetName() : "";
      vtkDataArray* same = to.GetArray(name.c_str());
      if ((name.starts_with(kMeshPrefix) || name == kElementIds) && same != nullptr &&
        AreSame(*known, *same))
      {
        to.AddArray(known);
      }
    }
  };
  share(*before.GetFieldData(), *grid.GetFieldData());
  share(*before.GetCellData(), *grid.GetCellData());
}

/// Replaces the grid by the deformed one.
void Warp(LoadedModel& input, const InputRequest& request)
{
  input.undeformed = input.grid;
  const WarpedGrid warped =
    WarpGrid(input.grid, request.WarpBy(request.warp->field, request.warp->scale));
  input.grid = warped.grid;
  for (const std::string& name : warped.leftOut)
  {
    input.diagnostics.push_back("--warp: field '" + name +
      "' is left out; it is an H(curl), H(div) or density field, whose values depend on the map");
  }
}

/// Replaces the grid by one with the complex fields at a phase.
void Turn(LoadedModel& input, double phase)
{
  const auto turned = vtkSmartPointer<vtkUnstructuredGrid>::Take(input.grid->NewInstance());
  turned->ShallowCopy(input.grid);
  if (vtkHighOrderCalculator::DefinePhase(turned, phase) == 0 && input.grid->GetNumberOfCells() > 0)
  {
    throw Error("--phase: the input has no complex field, which is a pair NAME_real and NAME_imag; "
                "leave it out");
  }
  const std::vector<std::string> stored = StoredFieldNames(turned);
  const auto isStored = [&stored](const std::string& name)
  { return std::ranges::find(stored, name) != stored.end(); };
  for (const std::string& name : stored)
  {
    if (isStored(name + "_real") && isStored(name + "_imag"))
    {
      input.diagnostics.push_back(
        fmt::format("--phase: field '{0}' is stored beside '{0}_real' and '{0}_imag' and stays as "
                    "it is; rename it to see the complex field",
          name));
    }
  }
  input.grid = turned;
}

/// From the grid to the model that is shown.
void Finish(LoadedModel& input, const InputRequest& request)
{
  input.source = input.grid;
  if (request.phase)
  {
    Turn(input, *request.phase);
  }
  if (request.warp)
  {
    Warp(input, request);
  }
  input.model = HighOrderModel::From(input.grid);
  input.elements = input.model->GetMesh().Elements();
  if (request.truncateOrder)
  {
    Truncate(input, *request.truncateOrder);
  }
}
} // namespace

LoadedModel Changed(const LoadedModel& before, const InputRequest& request)
{
  LoadedModel input = before;
  input.grid = before.source;
  input.truncations.clear();
  input.diagnostics.clear();
  Finish(input, request);
  return input;
}

LoadedModel LoadModel(const InputRequest& request, const std::string& field, Stopwatch& stopwatch,
  vtkUnstructuredGrid* before)
{
  InputGrid read = ReadInput(request);
  LoadedModel input;
  input.grid = read.grid;
  input.times = std::move(read.times);
  input.step = read.step;
  input.diagnostics = std::move(read.notes);
  stopwatch.Stage("read");
  try
  {
    if (AreSeveralProcesses() && input.grid->GetNumberOfCells() == 0)
    {
      return input; // this one has no share of it
    }
    if (!HasHighOrderArrays(input.grid))
    {
      Convert(input, request, field);
    }
    else if (request.gaussLobatto || request.mirroredWedges)
    {
      throw Error("it holds coefficients, whose nodes nobody asks for; leave out --nodes and "
                  "--mirrored-wedges");
    }
    if (!input.times.empty())
    {
      // Expressions read it as t.
      input.grid->GetInformation()->Set(
        vtkDataObject::DATA_TIME_STEP(), input.times[static_cast<std::size_t>(input.step)]);
    }
    if (before != nullptr)
    {
      ShareMesh(*before, *input.grid);
    }
    Finish(input, request);
  }
  catch (const Error& error)
  {
    throw Error("'" + request.files[0] + "': " + error.what());
  }
  stopwatch.Stage("convert");
  return input;
}

void ForEachStep(const InputRequest& request, const std::string& field, Stopwatch& stopwatch,
  const std::function<void(const LoadedModel&)>& visit)
{
  LoadedModel now = LoadModel(request, field, stopwatch);
  if (!request.allSteps)
  {
    visit(now);
    return;
  }
  if (now.times.empty())
  {
    throw Error("--time-step all: '" + request.files[0] + "' has no time steps; leave it out");
  }
  InputRequest one = request;
  one.allSteps = false;
  const int steps = static_cast<int>(now.times.size());
  for (int step = 0; step < steps; ++step)
  {
    if (step != now.step)
    {
      one.step = step;
      now = LoadModel(one, field, stopwatch, now.source);
    }
    visit(now);
  }
}

std::string SolutionName(
  const std::string& name, const InputRequest& request, const LoadedModel& input)
{
  if (request.allSteps || input.times.size() < 2)
  {
    return name;
  }
  const std::size_t files = request.files.size();
  if (files < input.times.size())
  {
    return fmt::format("{}, step {}", name, input.step);
  }
  const std::filesystem::path first = request.files[files - input.times.size()];
  return fmt::format("{} to {}, step {}", first.filename().string(), name, input.step);
}

double TimeOf(const LoadedModel& input)
{
  return input.times.empty() ? 0.0 : input.times[static_cast<std::size_t>(input.step)];
}

void AddTime(Table& table, const LoadedModel& input)
{
  if (!input.times.empty())
  {
    table.Row("time", "{}, step {} of {} from {} to {}",
      Short(input.times[static_cast<std::size_t>(input.step)]), input.step, input.times.size(),
      Short(input.times.front()), Short(input.times.back()));
  }
}

void AddTime(nlohmann::ordered_json& summary, const LoadedModel& input)
{
  if (!input.times.empty())
  {
    summary["time_step"] = input.step;
    summary["time"] = input.times[static_cast<std::size_t>(input.step)];
  }
}

Box3 BoxOf(const HighOrderModel& model)
{
  return model.GetMesh().Elements() > 0 ? model.GetLocator().Bounds()
                                        : Box3{ Vec3(-1.0), Vec3(1.0) };
}

void WarnOfDiagnostics(const LoadedModel& input)
{
  for (const std::string& line : input.diagnostics)
  {
    Warn(line);
  }
}

const Field& VectorField(
  const HighOrderModel& model, const std::string& option, const std::string& name)
{
  const Field& field = model.GetField(name);
  const int components = field.values.components;
  if (components != 2 && components != 3)
  {
    throw Error(fmt::format("{}: field '{}' has {} component{}; vectors have 3, or 2 in a plane",
      option, name, components, components == 1 ? "" : "s"));
  }
  return field;
}

const Field& FieldOrFirst(const HighOrderModel& model, const std::string& name)
{
  if (!name.empty())
  {
    return model.GetField(name);
  }
  const Field& first = model.Fields().front();
  Note("field '" + first.name + "'" +
    (model.Fields().size() > 1 ? ", the first of " + FieldNames(model) + "; choose with --field"
                               : ""));
  return first;
}

std::array<int, 2> OrderRange(const Expansion& expansion)
{
  std::array<int, 2> range{ 0, -1 };
  for (int e = 0; e < expansion.Elements(); ++e)
  {
    const int order = expansion.SpaceOf(e).MaxOrder();
    range[0] = e == 0 ? order : std::min(range[0], order);
    range[1] = std::max(range[1], order);
  }
  return range;
}

std::string OrderText(const std::array<int, 2>& range)
{
  const auto [lowest, highest] = range;
  if (highest < lowest)
  {
    return "none";
  }
  return lowest == highest ? fmt::format("{}", lowest) : fmt::format("{} to {}", lowest, highest);
}

std::string FieldKind(const Field& field)
{
  const int components = field.values.components;
  return fmt::format(" ({}{})",
    components == 1 ? std::string() : fmt::format("{} components, ", components),
    field.function != nullptr ? "an expression" : "order " + OrderText(OrderRange(field.values)));
}
} // namespace pixelexact
