// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Help.h"

#include "Base/Numbers.h"
#include "Base/Report.h"
#include "Base/Settings.h"

#include <CLI/CLI.hpp>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace pixelexact
{
namespace
{
constexpr int kDefaultWidth = 100;
constexpr int kMinWidth = 40;
constexpr std::size_t kIndent = 2;
/// The column of descriptions.
constexpr std::size_t kColumn = 26;
/// The group of options that have no row in the table.
constexpr const char* kProgramGroup = "Program";

/// Returns the columns of $COLUMNS or of the terminal; kDefaultWidth where neither is known.
std::size_t TerminalWidth()
{
  int width = 0;
  if (const char* columns = std::getenv("COLUMNS");
      columns == nullptr || !ParseInteger(columns, width) || width <= 0)
  {
    winsize size{};
    width =
      ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kDefaultWidth;
  }
  return static_cast<std::size_t>(std::max(width, kMinWidth));
}

/// Appends the words of a text at column `indent` in lines of at most `width` columns. `text` ends
/// with the beginning of the current line. A word that is longer than a line is not broken.
void Wrap(std::string& text, const std::string& words, std::size_t indent, std::size_t width)
{
  std::size_t column = text.size() - (text.rfind('\n') + 1);
  bool first = true;
  for (const std::string& word : WordsIn(words))
  {
    if (!first && column + 1 + word.size() > width)
    {
      text += '\n' + std::string(indent, ' ');
      column = indent;
      first = true;
    }
    text += (first ? "" : " ") + word;
    column += (first ? 0 : 1) + word.size();
    first = false;
  }
  text += '\n';
}

/// Appends a term at the left, and its meaning in a column of its own.
void AddEntry(std::string& text, const std::string& term, const std::string& meaning)
{
  text += std::string(kIndent, ' ') + term;
  const std::size_t end = kIndent + term.size();
  text += end < kColumn ? std::string(kColumn - end, ' ') : '\n' + std::string(kColumn, ' ');
  Wrap(text, meaning, kColumn, TerminalWidth());
}

const Setting* SettingOf(const CLI::App& command, const CLI::Option& option)
{
  const std::vector<std::string>& names = option.get_lnames();
  return FindSetting(
    command.get_name(), names.empty() ? option.get_name(true) : "--" + names.front());
}

/// Returns " Needs --a, --b."; empty for no options.
std::string Related(const char* how, std::string_view names)
{
  return names.empty() ? std::string()
                       : " " + std::string(how) + " " + Listed(WordsIn(names)) + ".";
}

void AddOptions(std::string& text, const CLI::App& command, bool all)
{
  std::string group;
  for (const CLI::Option* option : OptionsInOrder(command))
  {
    const Setting* row = SettingOf(command, *option);
    if (!all && (row == nullptr || !HasWord(row->common, command.get_name())))
    {
      continue;
    }
    if (const std::string own = GroupOf(command, *option); all && own != group)
    {
      group = own;
      text += '\n';
      Wrap(text, group + ":", 0, TerminalWidth());
    }
    AddEntry(text, UsageOf(*option), DescriptionOf(command, *option));
  }
}

std::vector<const CLI::App*> CommandsIn(const CLI::App& program)
{
  return program.get_subcommands([](const CLI::App*) { return true; });
}

class HelpFormatter : public CLI::FormatterBase
{
public:
  std::string make_help(
    const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override
  {
    const bool all = mode == CLI::AppFormatMode::All;
    return app->get_parent() == nullptr ? OfProgram(*app, all) : OfCommand(*app, name, all);
  }

private:
  static std::string OfCommand(const CLI::App& command, const std::string& name, bool all)
  {
    std::string text;
    Wrap(text, command.get_description() + ".", 0, TerminalWidth());
    text += "\nUsage: " + name + " INPUT... [options]\n" + (all ? "" : "\n");
    AddOptions(text, command, all);
    if (!all)
    {
      text += "\nAll options, by group: " + name + " --help-all\n";
    }
    return text;
  }

  static std::string OfProgram(const CLI::App& program, bool all)
  {
    std::string text = program.get_description() + "\n\nUsage: " + program.get_name() +
      " COMMAND INPUT... [options]\n\nCommands:\n";
    for (const CLI::App* command : CommandsIn(program))
    {
      AddEntry(text, command->get_name(), command->get_description() + ".");
    }
    AddOptions(text, program, true);
    text += program.get_footer() + '\n';
    if (!all)
    {
      return text + "All options of a command, by group: " + program.get_name() +
        " COMMAND --help-all\n";
    }
    for (const CLI::App* command : CommandsIn(program))
    {
      const std::string name = program.get_name() + " " + command->get_name();
      text += '\n' + std::string(TerminalWidth(), '-') + '\n' + name + ": ";
      text += OfCommand(*command, name, true);
    }
    return text;
  }
};
} // namespace

void AddHelp(CLI::App& program)
{
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_help_flag("-h,--help", "Show the options that most users need.");
  program.set_help_all_flag("--help-all", "Show all options, by group.");
}

std::vector<const CLI::Option*> OptionsInOrder(const CLI::App& command)
{
  std::vector<const CLI::Option*> options = command.get_options();
  const auto rank = [&command](const CLI::Option* option)
  {
    const Setting* row = SettingOf(command, *option);
    return row != nullptr ? row - Settings().data() : std::ptrdiff_t(Settings().size());
  };
  std::ranges::stable_sort(options, {}, rank);
  return options;
}

std::string DescriptionOf(const CLI::App& command, const CLI::Option& option)
{
  const Setting* row = SettingOf(command, option);
  return row == nullptr
    ? option.get_description()
    : option.get_description() + Related("Needs", row->needs) + Related("Not with", row->excludes);
}

std::string UsageOf(const CLI::Option& option)
{
  if (option.get_positional())
  {
    return option.get_name(true) + "...";
  }
  std::string usage = option.get_name(false, true);
  if (option.get_items_expected_max() > 0)
  {
    const std::string form = option.get_type_name();
    usage += (form.starts_with("[=") ? "" : " ") + form;
  }
  return usage;
}

std::string GroupOf(const CLI::App& command, const CLI::Option& option)
{
  const Setting* row = SettingOf(command, option);
  return row != nullptr ? std::string(row->group) : kProgramGroup;
}
} // namespace pixelexact
