// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Defaults.h"

#include "Base/Command.h"
#include "Base/CommandWords.h"
#include "Base/FileOrPipe.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace pixelexact
{
namespace
{
constexpr const char* kVariable = "PIXELEXACT_OPTIONS";
constexpr const char* kNone = "--no-config";
constexpr const char* kFile = "--config";

using Options = std::set<const CLI::Option*>;

std::string NameOf(const std::string& word)
{
  return word.substr(0, word.find('='));
}

/// The options that words, as PrepareWords gives them, hold.
Options HeldBy(const CLI::App& command, const std::vector<std::string>& words)
{
  Options held;
  for (const std::string& word : words)
  {
    if (word == "--")
    {
      break;
    }
    if (const CLI::Option* option =
          word.starts_with("-") ? command.get_option_no_throw(NameOf(word)) : nullptr)
    {
      held.insert(option);
    }
  }
  return held;
}

/// Whether the command line leaves room for it.
bool IsOpen(const CLI::Option* option, const Options& given)
{
  const auto excludes = [](const CLI::Option* a, const CLI::Option* b)
  {
    const auto& others = a->get_excludes();
    return std::ranges::any_of(others, [b](const CLI::Option* one) { return one == b; });
  };
  return !given.contains(option) &&
    std::ranges::none_of(given,
      [&](const CLI::Option* other) { return excludes(option, other) || excludes(other, option); });
}

std::string ValueOf(const std::string& file, const std::string& name, const nlohmann::json& value)
{
  if (value.is_string())
  {
    return value.get<std::string>();
  }
  if (value.is_number())
  {
    return value.dump();
  }
  throw UsageError("'" + file + "': " + name +
    ": expected a text, a number, true, false, or an array of texts and numbers");
}

/// The words "--name=value" of a value.
std::vector<std::string> WordsOf(
  const std::string& file, const std::string& name, const nlohmann::json& value)
{
  const std::string word = "--" + name;
  if (value.is_boolean())
  {
    return value.get<bool>() ? std::vector{ word } : std::vector<std::string>();
  }
  std::vector<std::string> words;
  for (const nlohmann::json& one : value.is_array() ? value : nlohmann::json::array({ value }))
  {
    words.push_back(word + "=" + ValueOf(file, name, one));
  }
  return words;
}

const CLI::App* CommandNamed(const CLI::App& program, const std::string& name)
{
  const auto found =
    program.get_subcommands([&name](const CLI::App* one) { return one->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

bool AnyKnows(const CLI::App& program, const std::string& option)
{
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  return std::ranges::any_of(commands,
    [&option](const CLI::App* one) { return one->get_option_no_throw(option) != nullptr; });
}

nlohmann::json ReadObject(const std::string& file)
{
  const std::unique_ptr<std::istream> stream = OpenFileOrPipe(file);
  nlohmann::json object;
  try
  {
    object = nlohmann::json::parse(*stream);
  }
  catch (const nlohmann::json::exception& error)
  {
    throw UsageError("'" + file + "': it is no JSON: " + error.what());
  }
  const bool ofObjects = object.is_object() &&
    std::ranges::all_of(object, [](const nlohmann::json& one) { return one.is_object(); });
  if (!ofObjects)
  {
    throw UsageError("'" + file +
      R"(': expected an object of commands, such as { "render": { "colormap": "plasma" } })");
  }
  return object;
}

std::vector<std::string> OfFile(
  const CLI::App& program, const CLI::App& command, const std::string& file)
{
  std::vector<std::string> words;
  Options own;
  const nlohmann::json all = ReadObject(file);
  // The command's own options go before those of all commands.
  for (const std::string& section : { command.get_name(), std::string("*") })
  {
    if (!all.contains(section))
    {
      continue;
    }
    for (const auto& [name, value] : all[section].items())
    {
      const std::string word = "--" + name;
      const CLI::Option* option = command.get_option_no_throw(word);
      if (option == nullptr && (section != "*" || !AnyKnows(program, word)))
      {
        throw UsageError(fmt::format("'{}': {} has no option '{}'", file, section, name));
      }
      if (option != nullptr && own.insert(option).second)
      {
        const auto more = WordsOf(file, name, value);
        words.insert(words.end(), more.begin(), more.end());
      }
    }
  }
  for (const auto& [name, options] : all.items())
  {
    if (name != "*" && CommandNamed(program, name) == nullptr)
    {
      throw UsageError(fmt::format("'{}': there is no command '{}'", file, name));
    }
  }
  return words;
}

/// Split as a shell does, by blanks outside of quotes.
std::vector<std::string> OfVariable(const CLI::App& program, const CLI::App& command)
{
  const char* text = std::getenv(kVariable);
  std::vector<std::string> words{ command.get_name() };
  char quote = 0;
  bool open = false;
  for (const char* c = text; c != nullptr && *c != 0; ++c)
  {
    const bool blank = *c == ' ' || *c == '\t';
    if (quote == 0 && blank)
    {
      open = false;
      continue;
    }
    if (!open)
    {
      words.emplace_back();
      open = true;
    }
    if (quote == 0 && (*c == '\'' || *c == '"'))
    {
      quote = *c;
    }
    else if (*c == quote)
    {
      quote = 0;
    }
    else
    {
      words.back() += *c;
    }
  }
  if (quote != 0)
  {
    throw UsageError(std::string(kVariable) + ": the quote " + quote + " is not closed");
  }
  // Options of other commands are left out.
  std::vector<std::string> own{ command.get_name() };
  for (std::size_t i = 1; i < words.size(); ++i)
  {
    const std::string name = NameOf(words[i]);
    if (words[i].starts_with("-") && command.get_option_no_throw(name) == nullptr)
    {
      if (!AnyKnows(program, name))
      {
        throw UsageError(std::string(kVariable) + ": there is no option '" + name + "'");
      }
      const bool hasValue = words[i].find('=') != std::string::npos || i + 1 == words.size() ||
        words[i + 1].starts_with("-");
      i += hasValue ? 0 : 1;
      continue;
    }
    own.push_back(words[i]);
  }
  try
  {
    own = PrepareWords(program, own);
  }
  catch (const UsageError& error)
  {
    throw UsageError(std::string(kVariable) + ": " + error.what());
  }
  own.erase(own.begin());
  if (const auto other =
        std::ranges::find_if(own, [](const std::string& word) { return !word.starts_with("-"); });
      other != own.end())
  {
    throw UsageError(std::string(kVariable) + ": '" + *other + "' is no option");
  }
  return own;
}

/// The user's; empty: there is none.
std::string UsualFile()
{
  const char* folder = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path file;
  if (folder != nullptr && *folder != 0)
  {
    file = folder;
  }
  else if (home != nullptr && *home != 0)
  {
    file = std::filesystem::path(home) / ".config";
  }
  file /= "pixelexact/config.json";
  std::error_code ignored;
  return std::filesystem::exists(file, ignored) ? file.string() : std::string();
}

/// The file that the words name; empty: none.
std::string FileIn(const std::vector<std::string>& words)
{
  for (const std::string& word : words)
  {
    if (NameOf(word) == kFile && word.find('=') != std::string::npos)
    {
      std::string file = word.substr(word.find('=') + 1);
      if (!std::filesystem::exists(file))
      {
        throw UsageError(std::string(kFile) + ": there is no file '" + file + "'");
      }
      return file;
    }
  }
  return {};
}
} // namespace

std::vector<std::string> WithDefaults(
  const CLI::App& program, const std::vector<std::string>& words)
{
  const CLI::App* command = words.empty() ? nullptr : CommandNamed(program, words.front());
  if (command == nullptr || command->get_option_no_throw(kNone) == nullptr)
  {
    return words;
  }
  const std::vector<std::string> prepared = PrepareWords(program, words);
  if (std::ranges::find(prepared, kNone) != prepared.end())
  {
    return words;
  }
  std::vector<std::string> result{ words.front() };
  Options given = HeldBy(*command, prepared);
  const auto add = [&](const std::vector<std::string>& defaults)
  {
    Options added;
    for (const std::string& word : defaults)
    {
      const CLI::Option* option = command->get_option_no_throw(NameOf(word));
      if (option != nullptr && IsOpen(option, given))
      {
        result.push_back(word);
        added.insert(option);
      }
    }
    given.insert(added.begin(), added.end());
  };
  add(OfVariable(program, *command));
  const std::string named = FileIn(prepared);
  if (const std::string file = named.empty() ? UsualFile() : named; !file.empty())
  {
    add(OfFile(program, *command, file));
  }
  if (result.size() == 1)
  {
    return words;
  }
  result.emplace_back(kNone);
  result.insert(result.end(), words.begin() + 1, words.end());
  return result;
}
} // namespace pixelexact
