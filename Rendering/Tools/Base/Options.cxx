// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Options.h"

#include "Base/Command.h"
#include "Base/Nearest.h"
#include "Base/Numbers.h"
#include "Base/Settings.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

namespace pixelexact
{
namespace
{
/// The row of a command's option, which must have one of these types.
const Setting& RowOf(
  const CLI::App& command, const char* name, std::initializer_list<SettingType> types)
{
  const Setting* row = FindSetting(command.get_name(), name);
  if (row == nullptr || std::ranges::find(types, row->type) == types.end())
  {
    throw std::logic_error(
      command.get_name() + " " + name + ": the table of settings has no row of this type");
  }
  return *row;
}

int ReadInteger(const Setting& row, std::string_view text)
{
  int number = 0;
  if (!ParseInteger(text, number) || number < row.lowest || number > row.highest)
  {
    Refuse(std::string(row.LongName()), std::string(text), std::string(row.expected));
  }
  return number;
}

std::vector<int> ReadIntegers(const Setting& row, const std::string& text)
{
  std::vector<int> numbers;
  for (const std::string& part : text == "none" ? std::vector<std::string>() : SplitAt(text, ','))
  {
    int number = 0;
    if (!ParseInteger(part, number) || number < row.lowest || number > row.highest)
    {
      Refuse(std::string(row.LongName()), text, std::string(row.expected));
    }
    numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

double ReadNumber(const Setting& row, const std::string& text)
{
  double number = 0.0;
  if (!ParseNumber(text, number) || !std::isfinite(number) || number < row.lowest ||
    number > row.highest)
  {
    Refuse(std::string(row.LongName()), text, std::string(row.expected));
  }
  return number;
}

PixelLength ReadLength(const Setting& row, const std::string& text)
{
  PixelLength length{ 0.0, text.ends_with("pt"), std::string(row.LongName()),
    { row.lowest, row.highest } };
  // The limits are those of pixels.
  if (length.inPoints &&
    (!ParseNumber(std::string_view(text).substr(0, text.size() - 2), length.value) ||
      !std::isfinite(length.value)))
  {
    Refuse(length.option, text, std::string(row.expected) + ", or points, 0.5pt");
  }
  length.value = length.inPoints ? length.value : ReadNumber(row, text);
  return length;
}

std::vector<double> ReadNumbersOf(const Setting& row, const std::string& text)
{
  const std::string name(row.LongName());
  std::vector<double> numbers = ReadNumbers(name, text, row.count, std::string(row.form));
  if (row.type == SettingType::Color)
  {
    CheckColor(name, numbers);
  }
  return numbers;
}

void CheckChoice(const Setting& row, const std::string& text)
{
  if (!HasWord(row.choices, text))
  {
    throw UsageError(std::string(row.LongName()) + ": expected " + std::string(row.expected) +
      ", got '" + text + "'" + Suggestion(WordsIn(row.choices), text));
  }
}

/// Needs and conflicts of an option, with those options of its command that are there by now.
void Relate(CLI::App& command, const Setting& row, CLI::Option* option)
{
  for (const std::string& name : WordsIn(row.needs))
  {
    if (CLI::Option* other = command.get_option_no_throw(name))
    {
      option->needs(other);
    }
  }
  for (const std::string& name : WordsIn(row.excludes))
  {
    if (CLI::Option* other = command.get_option_no_throw(name))
    {
      option->excludes(other);
    }
  }
  for (const Setting& of : Settings())
  {
    const bool needs = HasWord(of.needs, row.LongName());
    const bool excludes = HasWord(of.excludes, row.LongName());
    CLI::Option* other = (needs || excludes) && HasWord(of.commands, command.get_name())
      ? command.get_option_no_throw(std::string(of.LongName()))
      : nullptr;
    if (other != nullptr && needs)
    {
      other->needs(option);
    }
    if (other != nullptr && excludes)
    {
      other->excludes(option);
    }
  }
}

/// Applies the rest of the row to an option that was added.
void Finish(CLI::App& command, const Setting& row, CLI::Option* option)
{
  std::string help(row.help);
  if (!row.defaultText.empty())
  {
    help += " Default: " + std::string(row.defaultText) + ".";
  }
  option->description(help)
    ->group(std::string(row.group))
    ->required(HasWord(row.required, command.get_name()));
  if (!row.form.empty())
  {
    option->type_name(std::string(row.form));
  }
  Relate(command, row, option);
}

/// Adds an option whose values `read` takes.
void AddReader(CLI::App& command, const Setting& row, const ReadText& read)
{
  const std::string names(row.names);
  if (row.repeated)
  {
    const auto readAll = [read](const std::vector<std::string>& texts)
    { std::ranges::for_each(texts, read); };
    Finish(command, row,
      command
        .add_option_function<std::vector<std::string>>(names, readAll)
        // Takes one value after each --name, because the next argument may be an input file.
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
    return;
  }
  CLI::Option* option = command.add_option_function<std::string>(names, read);
  Finish(command, row, option);
  if (row.type == SettingType::NumberIfAny)
  {
    // PrepareWords puts the number where it is left out.
    option->default_str(std::string(row.implied))->expected(0, 1);
  }
}
} // namespace

void Bind(CLI::App& command, const char* name, bool& given)
{
  const Setting& row = RowOf(command, name, { SettingType::Flag });
  Finish(command, row, command.add_flag(std::string(row.names), given));
}

void Bind(CLI::App& command, const char* name, std::string& text)
{
  const Setting& row = RowOf(command, name, { SettingType::Text });
  Finish(command, row, command.add_option(std::string(row.names), text));
}

void Bind(CLI::App& command, const char* name, std::vector<std::string>& texts)
{
  const Setting& row = RowOf(command, name, { SettingType::Texts });
  Finish(command, row, command.add_option(std::string(row.names), texts));
}

void Bind(CLI::App& command, const char* name, std::vector<std::vector<std::string>>& groups)
{
  const Setting& row = RowOf(command, name, { SettingType::WordGroups });
  Finish(command, row, command.add_option(std::string(row.names), groups));
}

void Bind(CLI::App& command, const char* name, int& number)
{
  const Setting& row = RowOf(command, name, { SettingType::Integer });
  number = std::isnan(row.initial) ? number : static_cast<int>(row.initial);
  AddReader(command, row, [&](const std::string& text) { number = ReadInteger(row, text); });
}

void Bind(CLI::App& command, const char* name, std::optional<int>& number)
{
  const Setting& row = RowOf(command, name, { SettingType::Integer });
  AddReader(command, row, [&](const std::string& text) { number = ReadInteger(row, text); });
}

void Bind(CLI::App& command, const char* name, std::vector<int>& numbers)
{
  const Setting& row = RowOf(command, name, { SettingType::Integers });
  AddReader(command, row, [&](const std::string& text) { numbers = ReadIntegers(row, text); });
}

void Bind(CLI::App& command, const char* name, std::optional<std::vector<int>>& numbers)
{
  const Setting& row = RowOf(command, name, { SettingType::Integers });
  AddReader(command, row, [&](const std::string& text) { numbers = ReadIntegers(row, text); });
}

void Bind(CLI::App& command, const char* name, double& number)
{
  const Setting& row = RowOf(command, name, { SettingType::Number });
  number = std::isnan(row.initial) ? number : row.initial;
  AddReader(command, row, [&](const std::string& text) { number = ReadNumber(row, text); });
}

void Bind(CLI::App& command, const char* name, std::optional<double>& number)
{
  const Setting& row = RowOf(command, name, { SettingType::Number, SettingType::NumberIfAny });
  AddReader(command, row, [&](const std::string& text) { number = ReadNumber(row, text); });
}

void Bind(CLI::App& command, const char* name, PixelLength& length)
{
  const Setting& row = RowOf(command, name, { SettingType::Number });
  length.value = std::isnan(row.initial) ? length.value : row.initial;
  AddReader(command, row, [&](const std::string& text) { length = ReadLength(row, text); });
}

void Bind(CLI::App& command, const char* name, std::optional<PixelLength>& length)
{
  const Setting& row = RowOf(command, name, { SettingType::Number, SettingType::NumberIfAny });
  AddReader(command, row, [&](const std::string& text) { length = ReadLength(row, text); });
}

void Bind(CLI::App& command, const char* name, std::vector<double>& numbers)
{
  const Setting& row = RowOf(command, name, { SettingType::Numbers, SettingType::Color });
  AddReader(command, row, [&](const std::string& text) { numbers = ReadNumbersOf(row, text); });
}

void Bind(CLI::App& command, const char* name, std::vector<std::vector<double>>& values)
{
  const Setting& row = RowOf(command, name, { SettingType::Numbers });
  AddReader(
    command, row, [&](const std::string& text) { values.push_back(ReadNumbersOf(row, text)); });
}

void Bind(CLI::App& command, const char* name, ImageSize& size)
{
  const Setting& row = RowOf(command, name, { SettingType::Size });
  AddReader(command, row,
    [&](const std::string& text) { size = ParseImageSize(std::string(row.LongName()), text); });
}

void Bind(CLI::App& command, const char* name, const ReadText& read)
{
  const Setting& row = RowOf(command, name, { SettingType::Choice, SettingType::Read });
  AddReader(command, row,
    [&row, read](const std::string& text)
    {
      if (row.type == SettingType::Choice)
      {
        CheckChoice(row, text);
      }
      read(text);
    });
}

void FillHelp(
  CLI::App& command, const char* name, const std::string& placeholder, const std::string& text)
{
  CLI::Option* option = command.get_option(name);
  std::string help = option->get_description();
  const std::string word = "{" + placeholder + "}";
  help.replace(help.find(word), word.size(), text);
  option->description(help);
}

void Refuse(const std::string& option, const std::string& text, const std::string& form)
{
  throw UsageError(option + ": expected " + form + ", got '" + text + "'");
}

std::vector<double> ReadNumbers(
  const std::string& option, const std::string& text, int count, const std::string& form)
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

void CheckColor(const std::string& option, const std::vector<double>& color)
{
  if (std::ranges::any_of(color, [](double c) { return c < 0.0 || c > 1.0; }))
  {
    throw UsageError(option + ": red, green and blue lie between 0 and 1");
  }
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
  Bind(command, "--threads", options.threads);
  Bind(command, "--json", options.json);
  Bind(command, "--config", options.config);
  Bind(command, "--no-config", options.noConfig);
  Bind(command, "--quiet", options.quiet);
}
} // namespace pixelexact
