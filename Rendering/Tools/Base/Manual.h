// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// The page of man, in roff: all options of all commands.
[[nodiscard]] std::string ManualPage(const CLI::App& program);
/// The reference of options in Markdown, Module/Documentation/options.md.
[[nodiscard]] std::string OptionsPage(const CLI::App& program);
} // namespace pixelexact
