// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Processes.h"

#include <mpi.h>
#include <vtkMPIController.h>
#include <vtkNew.h>

namespace pixelexact
{
struct ProgramProcesses::Internals
{
  vtkNew<vtkMPIController> controller;
};

ProgramProcesses::ProgramProcesses(int* argc, char*** argv)
  : Data(std::make_unique<Internals>())
{
  Data->controller->Initialize(argc, argv);
  vtkMultiProcessController::SetGlobalController(Data->controller);
}

ProgramProcesses::~ProgramProcesses()
{
  Data->controller->Finalize();
  vtkMultiProcessController::SetGlobalController(nullptr);
}

void EndAllProcesses(int status)
{
  if (AreSeveralProcesses())
  {
    MPI_Abort(MPI_COMM_WORLD, status);
  }
}
} // namespace pixelexact
