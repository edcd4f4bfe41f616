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

// What a command tells while it works and when it is done.
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
  /// On stdout, or on stderr, where stdout is a file's.
  void Print(bool onStderr = false) const;

private:
  std::vector<std::pair<std::string, std::string>> Rows;
};

void AddStages(Table& table, const Stopwatch& stopwatch);
nlohmann::ordered_json ToJson(const Stopwatch& stopwatch);

/// One line on stdout. NaN and infinity, which JSON does not know, become null, and bytes that are
/// no UTF-8, which a name of an array or a file may hold, the replacement character.
void Print(const nlohmann::ordered_json& summary);
/// The summary of what failed.
void PrintError(const std::string& message);

/// Throws Error where something that was printed on stdout is lost, as on a full disk.
void FlushOutput();

/// Shows how far the work is, on stderr, when that is a terminal; clears its line when done.
class ProgressLine
{
public:
  explicit ProgressLine(std::string label);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `part` from 0 to 1. Always true: nothing aborts.
  bool operator()(double part);

private:
  std::string Label;
  bool Terminal;
  int Shown = -1;
};

/// Whether tables and notes are left out from here on.
void BeQuiet(bool quiet);

void Warn(const std::string& message);
/// Says on stderr what was chosen.
void Note(const std::string& message);

/// "a, b, c"
std::string Listed(const std::vector<std::string>& texts);

/// As printf's %g with so many digits, with NaN as "nan".
std::string Short(double number, int digits = 6);
} // namespace pixelexact
