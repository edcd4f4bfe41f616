// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <memory>

// The processes that mpirun started together, including this one. There are two programs:
// pixelexact, which starts without MPI, and pixelexact-mpi, by which pixelexact replaces itself
// under mpirun.
namespace pixelexact
{
/// Must live in the main function during the program's work.
class ProgramProcesses
{
public:
  /// In pixelexact: replaces the program by pixelexact-mpi where mpirun started several processes;
  /// throws Error where it is not installed. In pixelexact-mpi: initialises MPI and sets the global
  /// vtkMultiProcessController.
  ProgramProcesses(int* argc, char*** argv);
  ~ProgramProcesses();
  ProgramProcesses(const ProgramProcesses&) = delete;
  ProgramProcesses& operator=(const ProgramProcesses&) = delete;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};

/// Ends all processes at once after a failure of this one.
void EndAllProcesses(int status);

/// Whether there are several processes.
bool AreSeveralProcesses();
/// The number of this process, from 0. Process 0 prints and writes files for all.
int ProcessNumber();
/// The share of this process in an input that all read.
PieceOf PartOfThisProcess();
inline bool IsFirstProcess()
{
  return ProcessNumber() == 0;
}
} // namespace pixelexact
