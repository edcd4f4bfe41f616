// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Processes.h"

#include <vtkMultiProcessController.h>

namespace pixelexact
{
bool AreSeveralProcesses()
{
  auto* all = vtkMultiProcessController::GetGlobalController();
  return all != nullptr && all->GetNumberOfProcesses() > 1;
}

int ProcessNumber()
{
  auto* all = vtkMultiProcessController::GetGlobalController();
  return all != nullptr ? all->GetLocalProcessId() : 0;
}

PieceOf PartOfThisProcess()
{
  return AreSeveralProcesses() ? PieceOf{ ProcessNumber(),
    vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses() }
                               : PieceOf{};
}
} // namespace pixelexact
