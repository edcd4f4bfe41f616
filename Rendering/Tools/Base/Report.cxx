// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Report.h"

#include "Base/Output.h"

#include "Core/Base/Error.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace pixelexact
{
namespace
{
bool isQuiet = false;
} // namespace

void BeQuiet(bool quiet)
{
  isQuiet = quiet;
}

void Stopwatch::Stage(const std::string& name)
{
  const Clock::time_point now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - Begin).count();
  Begin = now;
  const auto known = std::ranges::find(Seconds, name, &std::pair<std::string, double>::first);
  if (known != Seconds.end())
  {
    known->second += seconds;
    return;
  }
  Seconds.emplace_back(name, seconds);
}

void Table::Row(const std::string& name, const std::string& value)
{
  Rows.emplace_back(name, value);
}

void Table::Print(bool onStderr) const
{
  if (isQuiet)
  {
    return;
  }
  std::ostream& stream = onStderr ? std::cerr : std::cout;
  std::size_t width = 0;
  for (const auto& [name, value] : Rows)
  {
    width = std::max(width, name.size());
  }
  for (const auto& [name, value] : Rows)
  {
    stream << fmt::format("{:{}}  {}\n", name, width, value);
  }
}

void AddStages(Table& table, const Stopwatch& stopwatch)
{
  double sum = 0.0;
  std::vector<std::string> stages;
  for (const auto& [stage, seconds] : stopwatch.Stages())
  {
    sum += seconds;
    stages.push_back(Short(seconds, 3) + " " + stage);
  }
  table.Row("seconds", "{}: {}", Short(sum, 3), Listed(stages));
}

nlohmann::ordered_json ToJson(const Stopwatch& stopwatch)
{
  auto stages = nlohmann::ordered_json::object();
  for (const auto& [stage, seconds] : stopwatch.Stages())
  {
    stages[stage] = seconds;
  }
  return stages;
}

void Print(const nlohmann::ordered_json& summary)
{
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  std::cout << summary.dump(-1, ' ', false, replace) << '\n';
}

void PrintError(const std::string& message)
{
  Print({ { "error", message } });
}

void FlushOutput()
{
  errno = 0;
  // fmt prints with stdio, which stores an error and retries here.
  const bool failed = !std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || failed)
  {
    // A large write that failed leaves nothing to flush, and no reason: one byte more fails as it
    // did, at the end of an output that is not whole anyway.
    int reason = errno;
    if (reason == 0 && write(STDOUT_FILENO, "\n", 1) < 0)
    {
      reason = errno;
    }
    CannotWrite("to standard output", reason);
  }
}

ProgressLine::ProgressLine(std::string label)
  : Label(std::move(label))
  , Terminal(isatty(STDERR_FILENO) != 0)
{
}

ProgressLine::~ProgressLine()
{
  if (Terminal && Shown >= 0)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

bool ProgressLine::operator()(double part)
{
  const int percent = static_cast<int>(100.0 * std::clamp(part, 0.0, 1.0));
  if (Terminal && percent != Shown)
  {
    Shown = percent;
    std::cerr << '\r' << Label << ' ' << percent << " %" << std::flush;
  }
  return true;
}

void Warn(const std::string& message)
{
  std::cerr << "pixelexact: warning: " << message << '\n';
}

void Note(const std::string& message)
{
  if (!isQuiet)
  {
    std::cerr << "pixelexact: " << message << '\n';
  }
}

std::string Listed(const std::vector<std::string>& texts)
{
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string Rounded(double number, bool upwards, int digits)
{
  const auto print = [digits](double v) { return fmt::format("{:.{}g}", v, digits); };
  const std::string text = print(number);
  const double printed = std::strtod(text.c_str(), nullptr);
  // One unit in the last digit.
  const double step = std::pow(10.0, std::floor(std::log10(std::fabs(number))) + 1 - digits);
  return (upwards ? printed < number : printed > number) ? print(number + (upwards ? step : -step))
                                                         : text;
}

std::string Short(double number, int digits)
{
  return std::isnan(number) ? "nan" : fmt::format("{:.{}g}", number, digits);
}
} // namespace pixelexact
