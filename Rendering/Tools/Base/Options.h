// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// CLI11 takes long to compile: only Options.cxx, CommandWords.cxx and Main.cxx include it.
namespace CLI
{
class App;
class Option;
} // namespace CLI

// Options of a command. Those with a value show `form` for it in the help; where that is
// "[=A|...]", the value is joined to the option, and is A where there is none (the next argument
// may be an input file). What cannot be read is refused with the option's name and what it expects.
namespace pixelexact
{
/// An option that was added, for what else there is to say of it.
class AddedOption
{
public:
  explicit AddedOption(CLI::Option* option)
    : Option(option)
  {
  }
  AddedOption& Group(const std::string& name);
  AddedOption& Required(bool required = true);
  AddedOption& Needs(const AddedOption& other);
  AddedOption& Excludes(const AddedOption& other);

private:
  CLI::Option* Option;
};

/// Reads the value of an option.
using ReadText = std::function<void(const std::string&)>;

AddedOption AddFlag(
  CLI::App& command, const std::string& name, bool& given, const std::string& help);

AddedOption AddText(CLI::App& command, const std::string& name, std::string& text, const char* form,
  const std::string& help);
/// The arguments that belong to no option.
AddedOption AddArguments(CLI::App& command, const std::string& name,
  std::vector<std::string>& texts, const char* form, const std::string& help);
AddedOption AddChoice(CLI::App& command, const std::string& name, const ReadText& read,
  const std::vector<std::string>& choices, const std::string& help);

/// Each --name takes all words up to the next option, and begins a group of its own.
AddedOption AddWordGroups(CLI::App& command, const std::string& name,
  std::vector<std::vector<std::string>>& groups, const char* form, const std::string& help);

/// From `lowest` to `highest`.
AddedOption AddInteger(CLI::App& command, const std::string& name, int& number, int lowest,
  int highest, const char* form, const std::string& help);
/// A finite number.
AddedOption AddNumber(CLI::App& command, const std::string& name, std::optional<double>& number,
  const char* form, const std::string& help);
struct NumberLimits
{
  double unsaid; ///< the number of an option that is given without one
  double lowest;
  double highest;
};
/// A number within limits, which may be left out after the option's name.
AddedOption AddNumberIfAny(CLI::App& command, const std::string& name,
  std::optional<double>& number, const NumberLimits& limits, const char* form,
  const std::string& help);
/// `count` comma-separated finite numbers, given at most once.
AddedOption AddNumbers(CLI::App& command, const std::string& name, std::vector<double>& numbers,
  int count, const char* form, const std::string& help);
/// The same for an option that may be given any number of times.
AddedOption AddRepeatedNumbers(CLI::App& command, const std::string& name,
  std::vector<std::vector<double>>& values, int count, const char* form, const std::string& help);

/// An image size "WxH", in pixels; or in millimetres or inches, "85x60mm", "3.5x2.5in".
struct ImageSize
{
  int width = 1000;
  int height = 1000;
  std::optional<std::array<double, 2>> inches; ///< as given; none: pixels were
};
/// Of prints, where sizes are lengths and nothing else is said.
inline constexpr double kUsualDpi = 300.0;
/// The pixels of a size that is a length, with so many to an inch; others stay. Throws UsageError.
ImageSize AtDpi(const ImageSize& size, double dpi);
AddedOption AddSize(
  CLI::App& command, const std::string& name, ImageSize& size, const std::string& help);

/// An option that `read` understands, which calls Refuse where it does not.
AddedOption AddRead(CLI::App& command, const std::string& name, const ReadText& read,
  const char* form, const std::string& help);
/// The same for an option that may be given any number of times.
AddedOption AddRepeated(CLI::App& command, const std::string& name, const ReadText& read,
  const char* form, const std::string& help);
[[noreturn]] void Refuse(
  const std::string& option, const std::string& text, const std::string& form);
/// `count` comma-separated finite numbers of an option; else Refuse.
std::vector<double> ReadNumbers(
  const std::string& option, const std::string& text, int count, const char* form);

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
