// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/ParallelRun.h"

#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace pixelexact
{
vtkMultiProcessController* ProcessesThatShare(vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  auto* processes = vtkMultiProcessController::GetGlobalController();
  vtkInformation* asked = output->GetInformationObject(0);
  const bool share = processes != nullptr && processes->GetNumberOfProcesses() > 1 &&
    asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) == processes->GetNumberOfProcesses() &&
    asked->Get(Pipeline::UPDATE_PIECE_NUMBER()) == processes->GetLocalProcessId();
  return share ? processes : nullptr;
}

void AskForParts(vtkInformationVector* input, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  auto* processes = ProcessesThatShare(output);
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* asked = input->GetInformationObject(i);
    asked->Set(Pipeline::UPDATE_PIECE_NUMBER(), processes ? processes->GetLocalProcessId() : 0);
    asked->Set(
      Pipeline::UPDATE_NUMBER_OF_PIECES(), processes ? processes->GetNumberOfProcesses() : 1);
    asked->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
}

bool HasNoShare(vtkInformationVector* input)
{
  auto* processes = vtkMultiProcessController::GetGlobalController();
  vtkDataObject* data = vtkDataObject::GetData(input);
  return processes != nullptr && processes->GetNumberOfProcesses() > 1 && data != nullptr &&
    data->GetNumberOfElements(vtkDataObject::CELL) == 0;
}

bool ComesInBlocks(bool known, vtkInformationVector* input, vtkInformationVector* output)
{
  return ProcessesThatShare(output) == nullptr
    ? known
    : vtkCompositeDataSet::SafeDownCast(vtkDataObject::GetData(input)) != nullptr;
}

int AnswerOfAll(int answer, vtkInformationVector* output)
{
  int least = answer;
  if (auto* processes = ProcessesThatShare(output))
  {
    processes->AllReduce(&answer, &least, 1, vtkCommunicator::MIN_OP);
  }
  return least;
}
} // namespace pixelexact
