// SPDX-License-Identifier: BSD-3-Clause
#include "Views/GridModel.h"

#include "HighOrderModel.h"

#include "Core/Base/Error.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace pixelexact
{
void AskForWhole(vtkInformationVector* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* asked = input->GetInformationObject(i);
    asked->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    asked->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    asked->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
}

const std::shared_ptr<HighOrderModel>& GridModel::Of(vtkDataObject* grid)
{
  if (grid == nullptr)
  {
    Model.reset();
    throw Error("no input: connect a vtkUnstructuredGrid that carries high-order arrays");
  }
  if (!Model || !Model->IsCurrent(grid))
  {
    // Stays alive until the new model is constructed, which may share its locator.
    const std::shared_ptr<HighOrderModel> stale = std::move(Model);
    Model = HighOrderModel::From(grid);
    ++Count;
  }
  return Model;
}
} // namespace pixelexact
