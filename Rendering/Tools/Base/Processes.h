// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <memory>

// The processes that mpirun started together, one of which this program is. There are two programs:
// pixelexact, which starts without MPI, and pixelexact-mpi, which the former becomes where mpirun
// started it.
namespace pixelexact
{
/// What a main function holds while it works.
class ProgramProcesses
{
public:
  /// Of pixelexact: where mpirun started several, the program becomes pixelexact-mpi; Error where
  /// there is none. Of that: MPI begins, and the others are the global vtkMultiProcessController's.
  ProgramProcesses(int* argc, char*** argv);
  ~ProgramProcesses();
  ProgramProcesses(const ProgramProcesses&) = delete;
  ProgramProcesses& operator=(const ProgramProcesses&) = delete;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};

/// Ends all of them at once, after a failure that the others do not know of.
void EndAllProcesses(int status);

/// Whether there are several.
bool AreSeveralProcesses();
/// Of this one, counted from 0; 0 speaks and writes files for all.
int ProcessNumber();
/// Its part of what all read.
PieceOf PartOfThisProcess();
inline bool IsFirstProcess()
{
  return ProcessNumber() == 0;
}
} // namespace pixelexact
