// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Options.h"

#include "Base/Command.h"
#include "Base/Nearest.h"
#include "Base/Numbers.h"
#include "Base/Report.h"

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pixelexact
{
namespace
{
// Limits of an image: its pixels and their buffers must be countable in 32 bits.
constexpr std::int64_t kMaxPixels = std::int64_t{ 1 } << 30;

void CheckPixels(double width, double height)
{
  if (!(width >= 1.0 && height >= 1.0 && width * height <= static_cast<double>(kMaxPixels)))
  {
    throw UsageError(fmt::format(
      "--size: {:.0f} x {:.0f} pixels; at least 1 x 1 and at most 2^30 of them", width, height));
  }
}

constexpr const char* kSizeForm =
  "WIDTHxHEIGHT in pixels, both at least 1, or in mm or in, as 85x60mm";

ImageSize ParseSize(const std::string& option, const std::string& text)
{
  ImageSize size;
  std::string_view numbers = text;
  const double perInch = numbers.ends_with("mm") ? 25.4 : numbers.ends_with("in") ? 1.0 : 0.0;
  numbers.remove_suffix(perInch > 0.0 ? 2 : 0);
  const auto cross = numbers.find('x');
  if (cross == std::string_view::npos)
  {
    Refuse(option, text, kSizeForm);
  }
  const std::string_view width = numbers.substr(0, cross);
  const std::string_view height = numbers.substr(cross + 1);
  if (perInch > 0.0)
  {
    std::array<double, 2> lengths{};
    if (!ParseNumber(width, lengths[0]) || !ParseNumber(height, lengths[1]) ||
      !(lengths[0] > 0.0 && lengths[1] > 0.0) || !std::isfinite(lengths[0] * lengths[1]))
    {
      Refuse(option, text, kSizeForm);
    }
    size.inches = { lengths[0] / perInch, lengths[1] / perInch };
    return AtDpi(size, kUsualDpi);
  }
  if (!ParseInteger(width, size.width) || !ParseInteger(height, size.height) || size.width < 1 ||
    size.height < 1)
  {
    Refuse(option, text, kSizeForm);
  }
  CheckPixels(size.width, size.height);
  return size;
}
} // namespace

ImageSize AtDpi(const ImageSize& size, double dpi)
{
  ImageSize pixels = size;
  if (size.inches)
  {
    const double width = std::round((*size.inches)[0] * dpi);
    const double height = std::round((*size.inches)[1] * dpi);
    CheckPixels(width, height);
    pixels.width = static_cast<int>(width);
    pixels.height = static_cast<int>(height);
  }
  return pixels;
}

AddedOption& AddedOption::Group(const std::string& name)
{
  Option->group(name);
  return *this;
}

AddedOption& AddedOption::Required(bool required)
{
  Option->required(required);
  return *this;
}

AddedOption& AddedOption::Needs(const AddedOption& other)
{
  Option->needs(other.Option);
  return *this;
}

AddedOption& AddedOption::Excludes(const AddedOption& other)
{
  Option->excludes(other.Option);
  return *this;
}

AddedOption AddFlag(
  CLI::App& command, const std::string& name, bool& given, const std::string& help)
{
  return AddedOption(command.add_flag(name, given, help));
}

AddedOption AddText(CLI::App& command, const std::string& name, std::string& text, const char* form,
  const std::string& help)
{
  return AddedOption(command.add_option(name, text, help)->type_name(form));
}

AddedOption AddArguments(CLI::App& command, const std::string& name,
  std::vector<std::string>& texts, const char* form, const std::string& help)
{
  return AddedOption(command.add_option(name, texts, help)->type_name(form));
}

AddedOption AddWordGroups(CLI::App& command, const std::string& name,
  std::vector<std::vector<std::string>>& groups, const char* form, const std::string& help)
{
  return AddedOption(command.add_option(name, groups, help)->type_name(form));
}

AddedOption AddChoice(CLI::App& command, const std::string& name, const ReadText& read,
  const std::vector<std::string>& choices, const std::string& help)
{
  const auto check = [read, name, choices](const std::string& text)
  {
    if (std::ranges::find(choices, text) == choices.end())
    {
      throw UsageError(name + ": expected one of " + Listed(choices) + ", got '" + text + "'" +
        Suggestion(choices, text));
    }
    read(text);
  };
  return AddedOption(command.add_option_function<std::string>(name, check, help)
                       ->type_name(fmt::format("{}", fmt::join(choices, "|"))));
}

AddedOption AddInteger(CLI::App& command, const std::string& name, int& number, int lowest,
  int highest, const char* form, const std::string& help)
{
  return AddRead(
    command, name,
    [&number, name, lowest, highest](const std::string& text)
    {
      if (!ParseInteger(text, number) || number < lowest || number > highest)
      {
        Refuse(name, text, fmt::format("a whole number from {} to {}", lowest, highest));
      }
    },
    form, help);
}

AddedOption AddNumber(CLI::App& command, const std::string& name, std::optional<double>& number,
  const char* form, const std::string& help)
{
  return AddRead(
    command, name,
    [&number, name](const std::string& text)
    {
      double value = 0.0;
      if (!ParseNumber(text, value) || !std::isfinite(value))
      {
        Refuse(name, text, "a finite number");
      }
      number = value;
    },
    form, help);
}

AddedOption AddNumberIfAny(CLI::App& command, const std::string& name,
  std::optional<double>& number, const NumberLimits& limits, const char* form,
  const std::string& help)
{
  const auto read = [&number, name, limits](const std::string& text)
  {
    double value = 0.0;
    if (!ParseNumber(text, value) || !(value >= limits.lowest && value <= limits.highest))
    {
      Refuse(name, text, fmt::format("a number from {} to {}", limits.lowest, limits.highest));
    }
    number = value;
  };
  // PrepareWords puts the default where it is left out.
  return AddedOption(command.add_option_function<std::string>(name, read, help)
                       ->type_name(fmt::format("[{}]", form))
                       ->default_str(fmt::format("{}", limits.unsaid))
                       ->expected(0, 1));
}

AddedOption AddNumbers(CLI::App& command, const std::string& name, std::vector<double>& numbers,
  int count, const char* form, const std::string& help)
{
  return AddRead(
    command, name,
    [&numbers, name, count, form](const std::string& text)
    { numbers = ReadNumbers(name, text, count, form); },
    form, help);
}

AddedOption AddRepeatedNumbers(CLI::App& command, const std::string& name,
  std::vector<std::vector<double>>& values, int count, const char* form, const std::string& help)
{
  return AddRepeated(
    command, name,
    [&values, name, count, form](const std::string& text)
    { values.push_back(ReadNumbers(name, text, count, form)); },
    form, help);
}

AddedOption AddSize(
  CLI::App& command, const std::string& name, ImageSize& size, const std::string& help)
{
  return AddRead(
    command, name, [&size, name](const std::string& text) { size = ParseSize(name, text); },
    "WxH[mm|in]", help);
}

AddedOption AddRead(CLI::App& command, const std::string& name, const ReadText& read,
  const char* form, const std::string& help)
{
  return AddedOption(command.add_option_function<std::string>(name, read, help)->type_name(form));
}

AddedOption AddRepeated(CLI::App& command, const std::string& name, const ReadText& read,
  const char* form, const std::string& help)
{
  const auto readAll = [read](const std::vector<std::string>& texts)
  { std::ranges::for_each(texts, read); };
  return AddedOption(command.add_option_function<std::vector<std::string>>(name, readAll, help)
                       ->type_name(form)
                       // One value after each --name: the next argument may be an input file.
                       ->expected(1)
                       ->allow_extra_args(false)
                       ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

void Refuse(const std::string& option, const std::string& text, const std::string& form)
{
  throw UsageError(option + ": expected " + form + ", got '" + text + "'");
}

std::vector<double> ReadNumbers(
  const std::string& option, const std::string& text, int count, const char* form)
{
  std::vector<double> numbers;
  std::string_view rest = text;
  while (true)
  {
    const auto comma = rest.find(',');
    double number = 0.0;
    if (!ParseNumber(rest.substr(0, comma), number) || !std::isfinite(number))
    {
      Refuse(option, text, form);
    }
    numbers.push_back(number);
    if (comma == std::string_view::npos)
    {
      break;
    }
    rest.remove_prefix(comma + 1);
  }
  if (numbers.size() != static_cast<std::size_t>(count))
  {
    Refuse(option, text, form);
  }
  return numbers;
}

bool IsGiven(const CLI::App& command, const std::string& name)
{
  const CLI::Option* option = command.get_option_no_throw(name);
  return option != nullptr && option->count() > 0;
}

std::vector<std::string> OptionsGiven(const CLI::App& command)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
  {
    if (option->count() > 0 && !option->get_lnames().empty())
    {
      names.push_back("--" + option->get_lnames().front());
    }
  }
  return names;
}

std::vector<std::string> SplitAt(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

CLI::App& AddCommand(CLI::App& program, const std::string& name, const std::string& help,
  const std::function<void()>& chosen)
{
  CLI::App* command = program.add_subcommand(name, help);
  command->callback(chosen);
  return *command;
}

void AddCommonOptions(CLI::App& command, CommonOptions& options)
{
  AddInteger(command, "--threads", options.threads, 1, 1 << 16, "N",
    "Number of threads (default: as the machine has)");
  AddFlag(command, "--json", options.json, "Print a machine-readable summary on stdout");
  AddText(command, "--config", options.config, "FILE",
    "Options that are not given, in JSON (default: ~/.config/pixelexact/config.json, where it is "
    "there; before it come those of the environment's PIXELEXACT_OPTIONS)");
  AddFlag(command, "--no-config", options.noConfig, "Neither that file nor PIXELEXACT_OPTIONS");
  AddFlag(command, "-q,--quiet", options.quiet,
    "Print no table, and not what was chosen; warnings and errors remain");
}
} // namespace pixelexact
