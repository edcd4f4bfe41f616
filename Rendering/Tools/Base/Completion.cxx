// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Completion.h"

#include "Base/Command.h"
#include "Base/Help.h"
#include "Base/Manual.h"
#include "Base/Options.h"
#include "Base/Settings.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact
{
namespace
{
struct OptionFacts
{
  std::vector<std::string> names; ///< with leading minus signs, the long one last
  std::string form;               ///< empty: a flag
  std::string help;
  std::vector<std::string> choices; ///< words that the value may be
  bool files = true;                ///< whether the value may name a file
  bool joined = false;              ///< the value is optional and must be joined by "="
};

struct CommandFacts
{
  std::string name;
  std::string help;
  std::vector<OptionFacts> options;
};

/// The choices of a form "a|b|c" where all are words of small letters; else none.
std::vector<std::string> ChoicesIn(const std::string& form)
{
  const bool optional = form.starts_with("[=");
  const std::string inner = optional ? form.substr(2, form.size() - 3) : form;
  std::vector<std::string> choices = SplitAt(inner, '|');
  std::erase_if(choices,
    [](const std::string& choice)
    {
      return choice.empty() ||
        !std::ranges::all_of(
          choice, [](unsigned char c) { return std::islower(c) != 0 || c == '+' || c == '-'; });
    });
  return inner.find('|') == std::string::npos && !optional ? std::vector<std::string>() : choices;
}

OptionFacts FactsOf(const CLI::App& command, const CLI::Option& option)
{
  OptionFacts facts;
  for (const std::string& name : option.get_snames())
  {
    facts.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames())
  {
    facts.names.push_back("--" + name);
  }
  facts.form = option.get_items_expected_max() > 0 ? option.get_type_name() : std::string();
  facts.help = DescriptionOf(command, option);
  const Setting* row = FindSetting(command.get_name(), facts.names.back());
  facts.choices =
    row != nullptr && !row->choices.empty() ? WordsIn(row->choices) : ChoicesIn(facts.form);
  const std::vector<std::string> parts = SplitAt(facts.form, '|');
  facts.files = facts.choices.empty() || std::ranges::find(parts, "FILE") != parts.end();
  facts.joined = facts.form.starts_with("[");
  return facts;
}

std::vector<CommandFacts> CommandsOf(const CLI::App& program)
{
  std::vector<CommandFacts> commands;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
  {
    CommandFacts facts{ command->get_name(), command->get_description(), {} };
    for (const CLI::Option* option : OptionsInOrder(*command))
    {
      if (!option->get_positional())
      {
        facts.options.push_back(FactsOf(*command, *option));
      }
    }
    commands.push_back(std::move(facts));
  }
  return commands;
}

std::string Joined(const std::vector<std::string>& texts)
{
  std::string all;
  for (const std::string& text : texts)
  {
    all += (all.empty() ? "" : " ") + text;
  }
  return all;
}

std::string Bash(const CLI::App& program)
{
  const std::vector<CommandFacts> commands = CommandsOf(program);
  std::vector<std::string> names;
  std::string options;
  std::string values;
  for (const CommandFacts& command : commands)
  {
    names.push_back(command.name);
    std::vector<std::string> words;
    for (const OptionFacts& option : command.options)
    {
      words.insert(words.end(), option.names.begin(), option.names.end());
      for (const std::string& name : option.names)
      {
        if (!option.form.empty() && !option.joined)
        {
          values += fmt::format("    {}:{}) COMPREPLY=($(compgen{}{} -- \"$cur\")) ;;\n",
            command.name, name, option.files ? " -f" : "",
            option.choices.empty() ? "" : " -W \"" + Joined(option.choices) + " \"");
        }
      }
    }
    options += fmt::format("    {}) options=\"{}\" ;;\n", command.name, Joined(words));
  }
  return fmt::format(R"(# Completion of pixelexact for bash, by "pixelexact --completion bash".
_pixelexact()
{{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} options=
  if [[ $COMP_CWORD -eq 1 ]]; then
    COMPREPLY=($(compgen -W "{} help --help --help-all --version --completion" -- "$cur"))
    return
  fi
  if [[ $prev == --completion ]]; then
    COMPREPLY=($(compgen -W "bash zsh man markdown" -- "$cur"))
    return
  fi
  COMPREPLY=()
  case "${{COMP_WORDS[1]}}:$prev" in
{}  esac
  [[ ${{#COMPREPLY[@]}} -gt 0 ]] && return
  case "${{COMP_WORDS[1]}}" in
    help) options="{}" ;;
{}  esac
  if [[ $cur == -* || ${{COMP_WORDS[1]}} == help ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$cur"))
  else
    COMPREPLY=($(compgen -f -- "$cur"))
  fi
}}
complete -o filenames -F _pixelexact pixelexact
)",
    Joined(names), values, Joined(names), options);
}

/// Escapes a text for single quotes in a specification of zsh's _arguments.
std::string ForZsh(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    if (c == '[' || c == ']' || c == ':' || c == '\\')
    {
      escaped += '\\';
    }
    escaped += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return escaped;
}

/// The completions of zsh for an option's value.
std::string ActionOf(const OptionFacts& option)
{
  const std::string choices = Joined(option.choices);
  if (option.choices.empty())
  {
    return "_files";
  }
  return option.files ? "{ compadd " + choices + "; _files }" : "(" + choices + ")";
}

std::string Zsh(const CLI::App& program)
{
  std::string commands;
  std::string cases;
  for (const CommandFacts& command : CommandsOf(program))
  {
    commands += fmt::format("    '{}:{}'\n", command.name, ForZsh(command.help));
    cases += fmt::format("    {})\n      _arguments \\\n", command.name);
    for (const OptionFacts& option : command.options)
    {
      for (const std::string& name : option.names)
      {
        const std::string value =
          option.form.empty() ? "" : ":" + ForZsh(option.form) + ":" + ActionOf(option);
        // "=": joined or separate; "=-": joined only.
        const char* join = option.form.empty() || name.size() == 2 ? ""
          : option.joined                                          ? "=-"
                                                                   : "=";
        cases += fmt::format("        '*{}{}[{}]{}{}' \\\n", name, join, ForZsh(option.help),
          option.joined ? ":" : "", value);
      }
    }
    cases += "        '*:file:_files'\n      ;;\n";
  }
  return fmt::format(R"(#compdef pixelexact
# Completion of pixelexact for zsh, by "pixelexact --completion zsh".
local -a commands
commands=(
{})
if (( CURRENT == 2 )); then
  _describe command commands
else
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
fi
)",
    commands, cases);
}
} // namespace

std::string GeneratedText(const CLI::App& program, const std::string& what)
{
  if (what == "bash")
  {
    return Bash(program);
  }
  if (what == "zsh")
  {
    return Zsh(program);
  }
  if (what == "man")
  {
    return ManualPage(program);
  }
  if (what == "markdown")
  {
    return OptionsPage(program);
  }
  throw UsageError(
    "--completion: there is none for '" + what + "'; there are bash, zsh, man and markdown");
}
} // namespace pixelexact
