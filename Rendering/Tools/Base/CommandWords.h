// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// The words of the command line as CLI11 reads them without misunderstanding:
/// - "help" and "help COMMAND" are --help;
/// - an option that takes a value and the word after it are joined as "--name=value", since values
///   may begin with a minus sign, which CLI11 takes for another option; words that begin with two
///   minus signs stay options;
/// - an option that may have a number gets its default where no number follows it;
/// - what follows the word "--" is left as it is.
/// Throws UsageError for a word that names no command or no option of the command, an option given
/// twice that takes one value, and an option without its value.
std::vector<std::string> PrepareWords(
  const CLI::App& program, const std::vector<std::string>& words);

/// Parses the words of a command of its own program, which begin with its name. `declare` adds its
/// options; the objects that they are bound to get their values. Returns the program, which they
/// may refer to. Throws UsageError for wrong usage.
std::shared_ptr<CLI::App> ParseCommand(
  const std::vector<std::string>& words, const std::function<void(CLI::App& command)>& declare);

/// The command that the words name; empty: none.
std::string CommandOf(const CLI::App& program, const std::vector<std::string>& words);
} // namespace pixelexact
