// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/ImageSize.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

// CLI11 takes long to compile: only sources of Base and Main.cxx include it.
namespace CLI
{
class App;
} // namespace CLI

// Options of a command. Their types, checks, limits, help, needs and conflicts are rows of the
// table of settings (Settings.h). Where a form is "[=A|...]", the value is joined to the option,
// and is A where there is none (the next argument may be an input file). What cannot be read is
// refused with the option's name and what it expects.
namespace pixelexact
{
/// Reads the value of an option; calls Refuse for a value that it does not understand.
using ReadText = std::function<void(const std::string&)>;

/// Adds the option `name` (its long name, or INPUT) to a command, as its row in the table states,
/// and binds it to a member, which gets the option's value. A number that is not optional first
/// gets the row's default. Throws std::logic_error where the table has no such row, or one of
/// another type.
void Bind(CLI::App& command, const char* name, bool& given);
void Bind(CLI::App& command, const char* name, std::string& text);
void Bind(CLI::App& command, const char* name, std::vector<std::string>& texts);
void Bind(CLI::App& command, const char* name, std::vector<std::vector<std::string>>& groups);
void Bind(CLI::App& command, const char* name, int& number);
void Bind(CLI::App& command, const char* name, std::optional<int>& number);
/// The numbers are sorted, and each is kept once.
void Bind(CLI::App& command, const char* name, std::vector<int>& numbers);
void Bind(CLI::App& command, const char* name, std::optional<std::vector<int>>& numbers);
void Bind(CLI::App& command, const char* name, double& number);
void Bind(CLI::App& command, const char* name, std::optional<double>& number);
/// A number of pixels, or of points where "pt" follows it.
void Bind(CLI::App& command, const char* name, PixelLength& length);
void Bind(CLI::App& command, const char* name, std::optional<PixelLength>& length);
/// The row has the type Numbers or Color.
void Bind(CLI::App& command, const char* name, std::vector<double>& numbers);
void Bind(CLI::App& command, const char* name, std::vector<std::vector<double>>& values);
void Bind(CLI::App& command, const char* name, ImageSize& size);
/// The row has the type Choice or Read. `read` gets texts that are choices of the row.
void Bind(CLI::App& command, const char* name, const ReadText& read);

/// Replaces the word {placeholder} in the help of an option.
void FillHelp(
  CLI::App& command, const char* name, const std::string& placeholder, const std::string& text);

[[noreturn]] void Refuse(
  const std::string& option, const std::string& text, const std::string& form);
/// Reads `count` comma-separated finite numbers of an option. Throws UsageError for other texts.
std::vector<double> ReadNumbers(
  const std::string& option, const std::string& text, int count, const std::string& form);
/// Throws UsageError for red, green and blue outside of 0 to 1.
void CheckColor(const std::string& option, const std::vector<double>& color);

/// Whether the command line holds the option, by its long name.
bool IsGiven(const CLI::App& command, const std::string& name);
/// The long names of all options that it holds.
std::vector<std::string> OptionsGiven(const CLI::App& command);

/// The parts of a text between separators.
std::vector<std::string> SplitAt(const std::string& text, char separator);

/// A command of the program; `chosen` is called where the command line names it.
CLI::App& AddCommand(CLI::App& program, const std::string& name, const std::string& help,
  const std::function<void()>& chosen);
} // namespace pixelexact
