// SPDX-License-Identifier: BSD-3-Clause
#include "Base/CommandWords.h"

#include "Base/Command.h"
#include "Base/Nearest.h"
#include "Base/Numbers.h"
#include "Base/Report.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace pixelexact
{
namespace
{
std::vector<std::string> Commands(const CLI::App& program)
{
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
  {
    names.push_back(command->get_name());
  }
  return names;
}

const CLI::App* FindCommand(const CLI::App& program, const std::string& word)
{
  const auto found =
    program.get_subcommands([&word](const CLI::App* one) { return one->get_name() == word; });
  return found.empty() ? nullptr : found.front();
}

bool IsOption(const std::string& word)
{
  return word.size() > 1 && word.front() == '-';
}

/// Splits "--name=value", "-n=value" and "-nvalue" into the name, and the value with its separator.
std::array<std::string, 2> Cut(const std::string& word)
{
  const auto end = word.starts_with("--") ? word.find('=') : std::size_t{ 2 };
  return end >= word.size() ? std::array{ word, std::string() }
                            : std::array{ word.substr(0, end), word.substr(end) };
}

std::string LongName(const CLI::Option& option)
{
  return "--" + option.get_lnames().front();
}

/// The value of an option that is given without one: the first choice in its form. Empty where the
/// option needs a value.
std::string UsualValue(const CLI::Option& option)
{
  const std::string form = option.get_type_name();
  return form.starts_with("[=") ? form.substr(2, form.find_first_of("|]") - 2) : std::string();
}

/// Whether a word is a number, or a number of points ("0.5pt").
bool IsLength(std::string_view word)
{
  double number = 0.0;
  word.remove_suffix(word.ends_with("pt") ? 2 : 0);
  return ParseNumber(word, number);
}

/// Reads the command line's words in order.
class Reader
{
public:
  Reader(const CLI::App& command, const std::vector<std::string>& words)
    : Command(command)
    , Words(words)
  {
  }

  std::vector<std::string> Read(std::size_t at)
  {
    for (; at < Words.size(); ++at)
    {
      if (Words[at] == "--")
      {
        Prepared.insert(
          Prepared.end(), Words.begin() + static_cast<std::ptrdiff_t>(at), Words.end());
        break;
      }
      if (IsOption(Words[at]))
      {
        at += ReadOption(at);
      }
      else
      {
        Prepared.push_back(Words[at]);
      }
    }
    return std::move(Prepared);
  }

private:
  /// A suggestion with the option whose name is nearest to the given one; empty where none is near.
  [[nodiscard]] std::string Suggestion(const std::string& given) const
  {
    if (given == "--minus")
    {
      return "; pixelexact compare A --with B -o IMAGE draws a difference";
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : Command.get_options())
    {
      for (const std::string& name : option->get_lnames())
      {
        names.push_back("--" + name);
      }
    }
    return pixelexact::Suggestion(names, given);
  }

  /// Reads the option at `at`. Returns the number of further words that belong to it.
  std::size_t ReadOption(std::size_t at)
  {
    auto [name, rest] = Cut(Words[at]);
    const CLI::Option* option = Command.get_option_no_throw(name);
    if (option == nullptr)
    {
      if (double number = 0.0; ParseNumber(Words[at], number))
      {
        throw UsageError("'" + Words[at] +
          "' belongs to no option; numbers of one are joined by commas, without blanks");
      }
      const std::string given = Words[at].starts_with("--") ? name : Words[at];
      throw UsageError(Command.get_parent() != nullptr
          ? Command.get_name() + " has no option '" + given + "'" + Suggestion(given)
          : "there is no option '" + given + "' before the command");
    }
    if (option->get_items_expected_max() == 0)
    {
      if (!rest.empty())
      {
        throw UsageError("'" + Words[at] + "': " + name + " takes no value");
      }
      Prepared.push_back(Words[at]);
      return 0;
    }
    if (option->get_items_expected_max() > 1)
    {
      return ReadGroup(at, *option, rest);
    }
    if (option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw &&
      !Given.insert(option).second)
    {
      throw UsageError(LongName(*option) + " was given more than once; give it once");
    }
    const bool joined = !rest.empty();
    if (const std::string usual = UsualValue(*option); !joined && !usual.empty())
    {
      Prepared.push_back(LongName(*option) + "=" + usual);
      return 0;
    }
    if (!joined && option->get_expected_min() == 0 &&
      (at + 1 == Words.size() || !IsLength(Words[at + 1])))
    {
      Prepared.push_back(LongName(*option) + "=" + option->get_default_str());
      return 0;
    }
    if (!joined && at + 1 < Words.size() && !Words[at + 1].starts_with("--"))
    {
      rest = Words[at + 1];
    }
    else if (joined && rest.front() == '=')
    {
      rest.erase(0, 1);
    }
    if (rest.empty())
    {
      throw UsageError(LongName(*option) + ": its value is missing, " + option->get_type_name());
    }
    Prepared.push_back(LongName(*option) + "=" + rest);
    return joined ? 0 : 1;
  }

  /// Reads an option that takes all words up to the next option; `rest` belongs to it.
  std::size_t ReadGroup(std::size_t at, const CLI::Option& option, const std::string& rest)
  {
    std::size_t end = at + 1;
    while (end < Words.size() && !IsOption(Words[end]))
    {
      ++end;
    }
    if (end == at + 1 && rest.empty())
    {
      throw UsageError(LongName(option) + ": its value is missing, " + option.get_type_name());
    }
    Prepared.push_back(LongName(option));
    if (!rest.empty())
    {
      Prepared.push_back(rest.substr(rest.front() == '=' ? 1 : 0));
    }
    Prepared.insert(Prepared.end(), Words.begin() + static_cast<std::ptrdiff_t>(at) + 1,
      Words.begin() + static_cast<std::ptrdiff_t>(end));
    return end - at - 1;
  }

  const CLI::App& Command;
  const std::vector<std::string>& Words;
  std::vector<std::string> Prepared;
  std::set<const CLI::Option*> Given;
};
} // namespace

std::string CommandOf(const CLI::App& program, const std::vector<std::string>& words)
{
  const auto first = std::find_if_not(words.begin(), words.end(), IsOption);
  return first != words.end() && FindCommand(program, *first) != nullptr ? *first : std::string();
}

std::shared_ptr<CLI::App> ParseCommand(
  const std::vector<std::string>& words, const std::function<void(CLI::App& command)>& declare)
{
  auto program = std::make_shared<CLI::App>();
  declare(*program->add_subcommand(words.front()));
  try
  {
    std::vector<std::string> arguments = PrepareWords(*program, words);
    // CLI11 takes arguments from the back.
    std::ranges::reverse(arguments);
    program->parse(std::move(arguments));
  }
  catch (const CLI::ParseError& error)
  {
    throw UsageError(error.what());
  }
  return program;
}

std::vector<std::string> PrepareWords(
  const CLI::App& program, const std::vector<std::string>& words)
{
  const std::string choices = "the commands are " + Listed(Commands(program));
  std::size_t at = 0;
  while (at < words.size() && IsOption(words[at]))
  {
    ++at;
  }
  // Help and version need no command; other options belong to a command.
  const std::vector<std::string> before(
    words.begin(), words.begin() + static_cast<std::ptrdiff_t>(at));
  if (at > 0)
  {
    return Reader(program, before).Read(0);
  }
  if (words.empty())
  {
    throw UsageError("name a command; " + choices);
  }
  if (words.front() == "help")
  {
    std::vector<std::string> asked(words.begin() + 1, words.end());
    asked.resize(std::min<std::size_t>(asked.size(), 1));
    asked.emplace_back("--help");
    return PrepareWords(program, asked);
  }
  const CLI::App* command = FindCommand(program, words.front());
  if (command == nullptr)
  {
    const std::string nearest = NearestOf(Commands(program), words.front());
    throw UsageError(nearest.empty()
        ? "there is no command '" + words.front() + "'; " + choices
        : "there is no command '" + words.front() + "'; did you mean " + nearest + "? " + choices);
  }
  std::vector<std::string> prepared = Reader(*command, words).Read(1);
  prepared.insert(prepared.begin(), words.front());
  return prepared;
}
} // namespace pixelexact
