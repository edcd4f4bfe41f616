// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
/// Runs the command-line tool that is beside this program, without its table, and waits for it.
/// Whether it succeeded; what it says goes to stderr.
bool RunTool(const std::vector<std::string>& words);
} // namespace pixelexact
