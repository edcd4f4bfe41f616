// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Command.h"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace pixelexact
{
namespace
{
// Limits of an image: its pixels and their buffers must be countable in 32 bits.
constexpr std::int64_t kMaxPixels = std::int64_t{ 1 } << 30;

template <class Number>
bool ParseWhole(std::string_view text, Number& number)
{
  const char* end = text.data() + text.size();
  const auto [last, failure] = std::from_chars(text.data(), end, number);
  return failure == std::errc() && last == end;
}

std::string_view Trim(std::string_view text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void Refuse(const std::string& option, const std::string& text, const char* form)
{
  throw CLI::ValidationError(option, "expected " + std::string(form) + ", got '" + text + "'");
}
} // namespace

bool ParseNumber(std::string_view text, double& number)
{
  text = Trim(text);
  // from_chars, which knows no locale, does not know a plus sign either.
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
  {
    text.remove_prefix(1);
  }
  return !text.empty() && ParseWhole(text, number);
}

std::vector<double> ParseNumbers(
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
  if (count >= 0 && numbers.size() != static_cast<std::size_t>(count))
  {
    Refuse(option, text, form);
  }
  return numbers;
}

ImageSize ParseSize(const std::string& option, const std::string& text)
{
  constexpr const char* form = "WIDTHxHEIGHT in pixels, both at least 1";
  const auto cross = text.find('x');
  ImageSize size;
  if (cross == std::string::npos ||
    !ParseWhole(std::string_view(text).substr(0, cross), size.width) ||
    !ParseWhole(std::string_view(text).substr(cross + 1), size.height) || size.width < 1 ||
    size.height < 1)
  {
    Refuse(option, text, form);
  }
  if (static_cast<std::int64_t>(size.width) * size.height > kMaxPixels)
  {
    throw CLI::ValidationError(option, "more than 2^30 pixels: '" + text + "'");
  }
  return size;
}

CLI::Option* AddNumbersOption(CLI::App& command, const std::string& name,
  std::vector<double>& numbers, int count, const char* form, const std::string& help)
{
  return command
    .add_option_function<std::string>(
      name,
      [&numbers, name, count, form](const std::string& text)
      { numbers = ParseNumbers(name, text, count, form); },
      help)
    ->type_name(form);
}

CLI::Option* AddRepeatedNumbersOption(CLI::App& command, const std::string& name,
  std::vector<std::vector<double>>& values, int count, const char* form, const std::string& help)
{
  return command
    .add_option_function<std::vector<std::string>>(
      name,
      [&values, name, count, form](const std::vector<std::string>& texts)
      {
        for (const std::string& text : texts)
        {
          values.push_back(ParseNumbers(name, text, count, form));
        }
      },
      help)
    ->type_name(form)
    // One value after each --name: the next argument may be an input file.
    ->expected(1)
    ->allow_extra_args(false)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::vector<std::string> JoinOptionValues(
  const CLI::App& program, const std::vector<std::string>& arguments)
{
  const CLI::App* command = &program;
  std::vector<std::string> joined;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    joined.push_back(argument);
    if (command == &program)
    {
      const auto chosen = program.get_subcommands(
        [&argument](const CLI::App* candidate) { return candidate->get_name() == argument; });
      command = chosen.empty() ? command : chosen.front();
    }
    const CLI::Option* option = argument.rfind("--", 0) == 0 && argument.size() > 2
      ? command->get_option_no_throw(argument)
      : nullptr;
    if (option != nullptr && option->get_items_expected_max() > 0 && i + 1 < arguments.size() &&
      arguments[i + 1].rfind("--", 0) != 0)
    {
      joined.back() += "=" + arguments[++i];
    }
  }
  return joined;
}

void AddCommonOptions(CLI::App& command, CommonOptions& options)
{
  command
    .add_option("--threads", options.threads, "Number of threads (default: as the machine has)")
    ->type_name("N")
    ->check(CLI::Range(1, 1 << 16));
  command.add_flag("--json", options.json, "Print a machine-readable summary on stdout");
}
} // namespace pixelexact
