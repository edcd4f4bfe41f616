// SPDX-License-Identifier: BSD-3-Clause
// The data of a process: its part of the mesh, coefficients, and arrays that are not fields.
#include "RepresentationInternals.h"

#include "CompositeParts.h"
#include "Core/Base/Error.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "MessageWords.h"
#include "Parts/PartBorders.h"

#include "vtkCompositeDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace
{
/// Whether any grid is without coefficients, or changed since.
bool NeedsConversion(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    return std::ranges::any_of(pixelexact::PartsOf(composite),
      [](const auto& part) { return !vtkUnstructuredGridToHighOrderGrid::IsConverted(part.grid); });
  }
  return !vtkUnstructuredGridToHighOrderGrid::IsConverted(vtkUnstructuredGrid::SafeDownCast(data));
}

/// The names of fields with coefficients, of a grid or of all blocks.
std::set<std::string> FieldNamesOf(vtkDataObject* data)
{
  std::vector<vtkUnstructuredGrid*> grids;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    std::ranges::transform(pixelexact::PartsOf(composite), std::back_inserter(grids),
      [](const auto& part) { return part.grid; });
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    grids.push_back(grid);
  }
  std::set<std::string> names;
  for (vtkUnstructuredGrid* grid : grids)
  {
    const std::vector<std::string> own = pixelexact::StoredFieldNames(grid);
    names.insert(own.begin(), own.end());
  }
  return names;
}
} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> vtkPixelExactRepresentation::Internals::WithCoefficients(
  vtkDataObject* data)
{
  auto shown = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  Interpolated.clear();
  // In a parallel run, processes may have no cells.
  if (HasCells(data) && NeedsConversion(data))
  {
    // Reads a copy, because the pipeline's object is in use by others.
    shown->ShallowCopy(data);
    Convert->SetInputDataObject(shown);
    Convert->Update();
    const std::set<std::string> before = FieldNamesOf(data);
    data = Convert->GetOutputDataObject(0);
    if (!before.empty())
    {
      // The converter adds those that the data have as arrays alone.
      std::ranges::set_difference(
        FieldNamesOf(data), before, std::inserter(Interpolated, Interpolated.end()));
    }
    shown = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  }
  shown->ShallowCopy(data);
  return shown;
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::Internals::ShowsInterpolated() const
{
  return Mapper->GetScalarVisibility() && Interpolated.contains(ColorArray);
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::Internals::HasOtherColors(vtkDataObject* data) const
{
  const auto isOther = [this](vtkUnstructuredGrid* grid)
  { return pixelexact::HasNamesake(grid, ColorArray, !ColorsCells); };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    return std::ranges::any_of(
      pixelexact::PartsOf(composite), [&](const auto& part) { return isOther(part.grid); });
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(data);
  return grid != nullptr && isOther(grid);
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::Internals::HasCells(vtkDataObject* data)
{
  return data != nullptr && data->GetNumberOfElements(vtkDataObject::CELL) > 0;
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::Internals::HasSeveralProcesses()
{
  auto* processes = vtkMultiProcessController::GetGlobalController();
  return processes != nullptr && processes->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::Internals::IsFirstProcess()
{
  auto* processes = vtkMultiProcessController::GetGlobalController();
  return processes == nullptr || processes->GetLocalProcessId() == 0;
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::Internals::HasLines()
{
  return Mapper->GetNumberOfContours() > 0 || Mapper->GetContourCount() > 0 ||
    Actor->GetProperty()->GetEdgeVisibility();
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::AskOthers()
{
  Internals& my = *this->Data;
  // Processes without cells have no description, so all of them exchange faces for slices as well.
  const bool isBoundary = my.Surface == BOUNDARY || my.Surface == SLICE_OR_CLIP;
  if (!Internals::HasSeveralProcesses() || !(isBoundary || my.HasLines()))
  {
    return;
  }
  if (vtkCompositeDataSet::SafeDownCast(my.Shown) != nullptr)
  {
    vtkWarningMacro(<< (isBoundary ? "the boundary of blocks is shown with the walls between the "
                                     "processes' parts"
                                   : "lines on blocks lack pixels beside other processes' parts")
                    << "; put the blocks together first (PixelExact Pack, Merge Blocks)");
  }
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(my.Shown);
  if (!grid)
  {
    // The other processes wait for this one, even if it has no cells.
    grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  try
  {
    auto* processes = vtkMultiProcessController::GetGlobalController();
    if (isBoundary)
    {
      grid = pixelexact::WithInnerFaces(grid, processes);
    }
    if (my.HasLines())
    {
      grid = pixelexact::WithNeighbours(grid, processes);
    }
    if (Internals::HasCells(grid))
    {
      my.Shown = grid;
      // Keeps the model until the mapper has it. The box remains that of the process' own part.
      const auto model = pixelexact::HighOrderModel::From(grid);
      my.Mapper->SetInputData(grid);
    }
  }
  catch (const pixelexact::Error& error)
  {
    my.Shown = nullptr;
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
  }
}
