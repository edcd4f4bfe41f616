// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
/// Runs the command-line tool beside this program, without its table, and waits for it. Returns
/// whether it succeeded; its messages go to stderr.
bool RunTool(const std::vector<std::string>& words);
} // namespace pixelexact
