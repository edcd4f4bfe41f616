// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Manual.h"

#include "Base/Help.h"
#include "Base/Settings.h"

#include "Core/Contour/SurfaceAbilities.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
/// Escapes a text for roff.
std::string ForRoff(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
  }
  return escaped.starts_with('.') || escaped.starts_with('\'') ? "\\&" + escaped : escaped;
}

/// Returns the names and the form of an option. The form begins with a blank unless it is joined.
std::array<std::string, 2> NamesAndForm(const CLI::Option& option)
{
  const std::string usage = UsageOf(option);
  const auto end = std::min(usage.find_first_of(" ["), usage.size());
  std::string names = usage.substr(0, end);
  if (const auto comma = names.find(','); comma != std::string::npos)
  {
    names.insert(comma + 1, " ");
  }
  return { names, usage.substr(end) };
}

/// Returns "vtkHighOrderMapper::SetSamples, ..." for "vtkHighOrderMapper.Samples ...".
std::string SettersOf(const Setting& row)
{
  std::vector<std::string> setters;
  for (const std::string& property : WordsIn(row.vtk))
  {
    const auto dot = property.find('.');
    setters.push_back(
      fmt::format("`{}::Set{}`", property.substr(0, dot), property.substr(dot + 1)));
  }
  return fmt::format("{}", fmt::join(setters, ", "));
}

std::string CommandsOfRow(const Setting& row)
{
  return fmt::format("{}", fmt::join(WordsIn(row.commands), ", "));
}

/// Returns an item of a Markdown list. `commands` are those that the title of the list names.
std::string ItemOf(const CLI::App& program, const Setting& row, std::string_view commands)
{
  const CLI::App* command = program.get_subcommand(WordsIn(row.commands).front());
  const CLI::Option* option = command->get_option(std::string(row.LongName()));
  std::string text = fmt::format("- **`{}`**", UsageOf(*option));
  text += row.commands != commands ? " (" + CommandsOfRow(row) + ")" : "";
  text += ": " + DescriptionOf(*command, *option);
  text += row.layer.empty() ? "" : fmt::format(" Key of `--layer`: `{}`.", row.layer);
  text += row.python.empty() ? "" : fmt::format(" Python: `{}`.", row.python);
  text += row.vtk.empty() ? "" : " VTK: " + SettersOf(row) + ".";
  text += row.toolOnly.empty() ? "" : fmt::format(" The tool alone has it: {}.", row.toolOnly);
  return text + "\n";
}

/// The uses of surfaces, for the page of options.
std::string SurfaceSection()
{
  std::string text = R"(
## Uses of surfaces

All surfaces are drawn. The program alone integrates over triangles. Degree: that of the polynomial in x; - where there is none.

| surface | option | VTK | degree | certified contour lines | integrals | clips integrals |
|---|---|---|---|---|---|---|
)";
  const auto code = [](const char* name)
  { return *name == '\0' ? std::string() : fmt::format("`{}`", name); };
  const auto word = [](bool has) { return has ? "yes" : "no"; };
  for (const SurfaceAbility& row : SurfaceAbilities())
  {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", row.plural, code(row.option),
      code(row.vtkClass), row.degree > 0 ? std::to_string(row.degree) : "-", word(row.lines),
      word(row.integrals), word(row.clips));
  }
  return text;
}
} // namespace

std::string ManualPage(const CLI::App& program)
{
  std::string text = fmt::format(R"(.TH PIXELEXACT 1 "" "PixelExact {}"
.SH NAME
pixelexact \- pixel-exact pictures of high-order finite-element fields
.SH SYNOPSIS
.B pixelexact
.I COMMAND INPUT...
.RI [ options ]
.SH DESCRIPTION
{}
.SH FILES
.TP
.I ~/.config/pixelexact/config.json
Options that the command line does not give: an object whose members are commands, or * for all of
them, each with options without their minus signs.
.SH ENVIRONMENT
.TP
.B PIXELEXACT_OPTIONS
The same as words of a command line; they go before the file's.
.SH EXIT STATUS
0 done, 1 the work failed, 2 wrong usage.
)",
    PIXELEXACT_VERSION, ForRoff(program.get_description()));
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
  {
    text += fmt::format(
      ".SH \"pixelexact {}\"\n{}.\n", command->get_name(), ForRoff(command->get_description()));
    std::string group;
    for (const CLI::Option* option : OptionsInOrder(*command))
    {
      if (option->get_positional())
      {
        continue;
      }
      if (const std::string own = GroupOf(*command, *option); own != group)
      {
        group = own;
        text += fmt::format(".SS \"{}\"\n", ForRoff(group));
      }
      const auto [names, form] = NamesAndForm(*option);
      text += fmt::format(".TP\n.BI \"{}\" \"{}\"\n{}\n", ForRoff(names), ForRoff(form),
        ForRoff(DescriptionOf(*command, *option)));
    }
  }
  return text;
}

std::string OptionsPage(const CLI::App& program)
{
  std::string text = R"(# Options of the command line

`pixelexact COMMAND --help-all` prints the same of one command. This page is generated:
[how to add a setting](how-to-add.md#a-setting).
)";
  std::string_view group;
  std::string_view commands;
  for (const Setting& row : Settings())
  {
    if (row.group != group)
    {
      group = row.group;
      commands = row.commands;
      text += fmt::format("\n## {}\n\nCommands: {}.\n\n", group, CommandsOfRow(row));
    }
    text += ItemOf(program, row, commands);
  }
  return text + SurfaceSection();
}
} // namespace pixelexact
