// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
/// Ends all processes of the program with this exit status.
using EndProcesses = void (*)(int status);

/// Runs the command that the program's arguments name, and returns the exit status: 0 done, 1 the
/// work failed, 2 wrong usage. Failures are printed. `endAll` is called after a failure of this
/// process alone.
int RunProgram(std::vector<std::string> words, EndProcesses endAll);
} // namespace pixelexact
