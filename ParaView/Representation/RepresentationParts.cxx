// SPDX-License-Identifier: BSD-3-Clause
// Exchange between processes about their parts.
#include "RepresentationInternals.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"
#include "MessageWords.h"
#include "Parts/PartBorders.h"

#include "vtkCompositeDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGrid.h"

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
