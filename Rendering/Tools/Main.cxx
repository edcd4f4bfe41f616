// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Processes.h"
#include "Base/Program.h"

#include "Core/Base/Error.h"

#include <cstdio>

int main(int argc, char** argv)
{
  try
  {
    const pixelexact::ProgramProcesses processes(&argc, &argv);
    return pixelexact::RunProgram({ argv + 1, argv + argc }, pixelexact::EndAllProcesses);
  }
  catch (const pixelexact::Error& error)
  {
    // The processes could not begin.
    std::fprintf(stderr, "pixelexact: %s\n", error.what());
    return 2;
  }
  catch (...)
  {
    std::fputs("pixelexact: internal error\n", stderr);
    return 1;
  }
}
