// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/core.h>
#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Messages and reports of commands.
namespace pixelexact
{
/// Seconds by stage of the work, in the order in which the stages ended for the first time.
class Stopwatch
{
public:
  /// The stage `name` ends now; it began when the one before ended. Stages of one name are summed.
  void Stage(const std::string& name);
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& Stages() const
  {
    return Seconds;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Begin = Clock::now();
  std::vector<std::pair<std::string, double>> Seconds;
};

/// Rows "name   value" with aligned values; a row without a name continues the one above.
class Table
{
public:
  void Row(const std::string& name, const std::string& value);
  template <class... Values>
  void Row(const std::string& name, fmt::format_string<Values...> text, Values&&... values)
  {
    Row(name, fmt::format(text, std::forward<Values>(values)...));
  }
  /// Prints to stdout, or to stderr where stdout is a file.
  void Print(bool onStderr = false) const;

private:
  std::vector<std::pair<std::string, std::string>> Rows;
};

void AddStages(Table& table, const Stopwatch& stopwatch);
nlohmann::ordered_json ToJson(const Stopwatch& stopwatch);

/// Prints one line to stdout. NaN and infinity, which JSON does not have, become null. Bytes that
/// are not UTF-8, which names of arrays and files may contain, become the replacement character.
void Print(const nlohmann::ordered_json& summary);
/// Prints the summary of a failure.
void PrintError(const std::string& message);

/// Throws Error where output to stdout is lost, as on a full disk.
void FlushOutput();

/// Shows progress on stderr if that is a terminal; clears its line when done.
class ProgressLine
{
public:
  explicit ProgressLine(std::string label);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `part` from 0 to 1. Always returns true: nothing aborts.
  bool operator()(double part);

private:
  std::string Label;
  bool Terminal;
  int Shown = -1;
};

/// Turns tables and notes off or on.
void BeQuiet(bool quiet);

void Warn(const std::string& message);
/// Prints to stderr what the program chose.
void Note(const std::string& message);

/// "a, b, c"
std::string Listed(const std::vector<std::string>& texts);

/// Formats as printf's %g with `digits` digits, with NaN as "nan".
std::string Short(double number, int digits = 6);
/// A number with `digits` digits, rounded down or up.
std::string Rounded(double number, bool upwards, int digits);
} // namespace pixelexact
