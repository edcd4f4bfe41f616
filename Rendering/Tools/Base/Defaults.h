// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// The words of a command line, and those that it does not give and a user's defaults do, before
/// them: of the environment's PIXELEXACT_OPTIONS, words as on a command line, and of a file,
/// $XDG_CONFIG_HOME/pixelexact/config.json (~/.config), or that of --config. A file is an object:
///
///     { "*": { "threads": 4 }, "render": { "colormap": "plasma", "figure": true,
///       "plane": [ "x", "z=10%" ] } }
///
/// Members are commands, or * for all that know an option; an option's value is a text, a number,
/// true (a flag), false (as if it was not there), or an array for one that is given several times.
/// An option that another one on the command line excludes stays out. With --no-config there are no
/// defaults; where some were used, the words end with it, so that they do the same once more.
///
/// Throws UsageError, naming file or variable, for what is no object, command, option or value.
std::vector<std::string> WithDefaults(
  const CLI::App& program, const std::vector<std::string>& words);
} // namespace pixelexact
