// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

// The help of commands: --help shows the options that most users need, --help-all all of them by
// group. Both are wrapped to the terminal's width.
namespace pixelexact
{
/// Gives a program, and the commands that it gets afterwards, --help and --help-all.
void AddHelp(CLI::App& program);

/// Returns the options of a command in the order of the table of settings. Those without a row,
/// such as --help, come last.
[[nodiscard]] std::vector<const CLI::Option*> OptionsInOrder(const CLI::App& command);
/// Returns the sentences about an option: what it does, its default, needs and conflicts.
[[nodiscard]] std::string DescriptionOf(const CLI::App& command, const CLI::Option& option);
/// Returns its names, the long one last, and its form, as the help shows them.
[[nodiscard]] std::string UsageOf(const CLI::Option& option);
/// Returns the title of its group.
[[nodiscard]] std::string GroupOf(const CLI::App& command, const CLI::Option& option);
} // namespace pixelexact
