// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Processes.h"

#include "Core/Base/Error.h"

#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace pixelexact
{
namespace
{
constexpr const char* kProgram = "pixelexact-mpi";

/// The number of processes that mpirun started, from the environment of Open MPI or of PMI (MPICH,
/// Intel).
int StartedTogether()
{
  int count = 1;
  for (const char* name : { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE" })
  {
    if (const char* text = std::getenv(name); text != nullptr)
    {
      const std::string_view digits = text;
      (void)std::from_chars(digits.data(), digits.data() + digits.size(), count);
    }
  }
  return count;
}
} // namespace

struct ProgramProcesses::Internals
{
};

ProgramProcesses::ProgramProcesses(int* /*argc*/, char*** argv)
{
  if (StartedTogether() < 2)
  {
    return;
  }
  std::error_code ignored;
  const std::filesystem::path beside =
    std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / kProgram;
  execv(beside.c_str(), *argv);
  execvp(kProgram, *argv);
  throw Error(
    "mpirun started several processes, which share the work in the program pixelexact-mpi; "
    "it is neither beside this one nor on the PATH: build with VTK's module ParallelMPI "
    "(Debian: libvtk9-dev, mpi-default-dev), or start one process without mpirun");
}

ProgramProcesses::~ProgramProcesses() = default;

void EndAllProcesses(int /*status*/) {}
} // namespace pixelexact
