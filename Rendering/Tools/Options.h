// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

// Reading of option values. What cannot be read throws CLI::ValidationError, which names the option
// and says what it expects.
namespace pixelexact
{
/// The number that the whole of `text` spells, in the C locale; no number: false.
[[nodiscard]] bool ParseNumber(std::string_view text, double& number);

/// Comma-separated finite numbers, exactly `count` of them (-1: one or more).
std::vector<double> ParseNumbers(
  const std::string& option, const std::string& text, int count, const char* form);

/// An image size "WxH".
struct ImageSize
{
  int width = 1000;
  int height = 1000;
};
ImageSize ParseSize(const std::string& option, const std::string& text);

/// Adds an option of `count` comma-separated numbers, given at most once.
CLI::Option* AddNumbersOption(CLI::App& command, const std::string& name,
  std::vector<double>& numbers, int count, const char* form, const std::string& help);

/// The same for an option that may be given any number of times.
CLI::Option* AddRepeatedNumbersOption(CLI::App& command, const std::string& name,
  std::vector<std::vector<double>>& values, int count, const char* form, const std::string& help);

/// Option values may begin with a minus sign, which CLI11 takes for another option: joins each
/// option that takes a value with the argument after it, as "--name=value". Arguments that begin
/// with two minus signs stay options.
std::vector<std::string> JoinOptionValues(
  const CLI::App& program, const std::vector<std::string>& arguments);
} // namespace pixelexact
