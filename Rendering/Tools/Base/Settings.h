// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

// The table of settings, Rendering/Settings/settings.json, as the program's options use it.
namespace pixelexact
{
enum class SettingType
{
  Flag,
  Text,
  Texts,      ///< the arguments that belong to no option
  WordGroups, ///< all words up to the next option; each use begins a group
  Choice,
  Integer,
  Integers, ///< comma-separated, or none
  Number,
  NumberIfAny, ///< a number that may be left out after the option's name
  Numbers,     ///< comma-separated
  Color,
  Size,
  Read ///< a form of its own, which a function of the program reads
};

/// A row of the table. Lists are words with blanks between them. Rendering/Settings/generate.py
/// writes the rows, in this order of members.
struct Setting
{
  SettingType type;
  bool repeated;          ///< whether the option may be given any number of times
  std::string_view names; ///< "-o,--output"; INPUT has no minus signs
  std::string_view commands;
  std::string_view common;   ///< those commands whose --help shows it
  std::string_view required; ///< those commands that need it
  std::string_view group;    ///< its title in the help
  std::string_view form;     ///< what the help shows for the value; empty: a flag
  std::string_view help;     ///< words in braces are filled in by FillHelp (Options.h)
  std::string_view defaultText;
  std::string_view expected; ///< what a value must be, for messages
  std::string_view choices;
  std::string_view needs;    ///< options without which it is refused
  std::string_view excludes; ///< options with which it is refused
  std::string_view implied;  ///< NumberIfAny: the number where it is left out
  std::string_view python;   ///< the keyword of pixelexact.cut or render
  std::string_view vtk;      ///< Class.Property
  std::string_view layer;    ///< its key in --layer
  std::string_view toolOnly; ///< why Python and VTK have no such setting; empty: they have, or may
  int count;                 ///< how many numbers a value has
  double lowest;
  double highest;
  double initial; ///< the default where it is one number, else NaN

  /// Returns the name without the short one, such as --output.
  [[nodiscard]] std::string_view LongName() const;
};

/// Returns all rows, in the order of the help.
[[nodiscard]] std::span<const Setting> Settings();
/// Returns the row of a command's option by its long name; null where there is none.
[[nodiscard]] const Setting* FindSetting(std::string_view command, std::string_view name);

[[nodiscard]] std::vector<std::string> WordsIn(std::string_view list);
[[nodiscard]] bool HasWord(std::string_view list, std::string_view word);
} // namespace pixelexact
