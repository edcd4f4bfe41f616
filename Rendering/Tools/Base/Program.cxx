// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Program.h"

#include "Base/Command.h"
#include "Base/CommandWords.h"
#include "Base/Completion.h"
#include "Base/Defaults.h"
#include "Base/Help.h"
#include "Base/Options.h"
#include "Base/Processes.h"
#include "Base/Report.h"

#include "Core/Base/Error.h"

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <optional>

namespace pixelexact
{
namespace
{
// Exit statuses, on which scripts rely.
constexpr int kDone = 0;
constexpr int kWorkFailed = 1;
constexpr int kWrongUsage = 2;

constexpr const char* kFooter = R"(
Exit status: 0 done, 1 the work failed, 2 wrong usage.
pixelexact --completion bash|zsh|man|markdown prints a shell's completion, the manual's page, or the
reference of options.

  pixelexact info toroid.vtu
  pixelexact render toroid.vtu --field u --plane 0,0,0,0,0,1 --output toroid.png
)";

int Fail(int status, const std::string& message, bool json)
{
  if (!IsFirstProcess())
  {
    return status; // the first one says the same
  }
  std::cerr << "pixelexact: " << message << '\n';
  if (json)
  {
    PrintError(message);
  }
  return status;
}

/// Reports a failure of this process only, and ends all processes, which may wait for this one.
int FailAlone(const std::string& message, bool json, EndProcesses endAll)
{
  if (!IsFirstProcess())
  {
    std::cerr << "pixelexact: process " << ProcessNumber() << ": " << message << '\n';
  }
  const int status = Fail(kWorkFailed, message, json);
  endAll(status);
  return status;
}

/// The exit status after success, unless printed output was lost.
int Done()
{
  try
  {
    FlushOutput();
  }
  catch (const Error& error)
  {
    return Fail(kWorkFailed, error.what(), false);
  }
  return kDone;
}

/// Runs the command.
int Perform(const Action& action, const CommonOptions& common, EndProcesses endAll)
{
  std::optional<tbb::global_control> limit;
  if (common.threads > 0)
  {
    limit.emplace(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(common.threads));
  }
  BeQuiet(common.quiet || !IsFirstProcess());
  try
  {
    action();
    return Done();
  }
  catch (const UsageError& error)
  {
    return Fail(kWrongUsage, error.what(), common.json);
  }
  catch (const Error& error)
  {
    return Fail(kWorkFailed, error.what(), common.json);
  }
  catch (const std::bad_alloc&)
  {
    return FailAlone("out of memory", common.json, endAll);
  }
  catch (const std::exception& error)
  {
    return FailAlone(error.what(), common.json, endAll);
  }
}

} // namespace

int RunProgram(std::vector<std::string> words, EndProcesses endAll)
{
  CLI::App program("Pixel-exact pictures of high-order finite-element fields.", "pixelexact");
  AddHelp(program);
  program.set_version_flag("--version", "pixelexact " PIXELEXACT_VERSION);
  program.require_subcommand(1);
  program.footer(kFooter);

  CommonOptions common;
  Action action;
  AddInfoCommand(program, common, action);
  AddProbeCommand(program, common, action);
  AddRenderCommand(program, common, action);
  AddBenchCommand(program, common, action);
  AddCompareCommand(program, common, action);
  AddIntegrateCommand(program, common, action);
  AddViewCommand(program, common, action);
  AddServeCommand(program, common, action);
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
  {
    AddCommonOptions(*command, common);
    command->set_version_flag("--version", "pixelexact " PIXELEXACT_VERSION);
  }

  const auto misused = [&](const std::string& message)
  {
    const std::string command = CommandOf(program, words);
    const bool json = std::ranges::find(words, "--json") != words.end();
    return Fail(kWrongUsage,
      message + "; see pixelexact " + command + (command.empty() ? "" : " ") + "--help", json);
  };
  try
  {
    if (words.size() == 2 && words.front() == "--completion")
    {
      std::cout << GeneratedText(program, words.back());
      return Done();
    }
    words = WithDefaults(program, words);
    common.words = words;
    std::vector<std::string> arguments = PrepareWords(program, words);
    // CLI11 takes arguments from the back.
    std::ranges::reverse(arguments);
    program.parse(std::move(arguments));
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() != kDone)
    {
      return misused(error.what());
    }
    program.exit(error);
    return Done();
  }
  catch (const UsageError& error)
  {
    return misused(error.what());
  }
  if (AreSeveralProcesses() && CommandOf(program, words) != "render")
  {
    return misused("this command is for one process; start it without mpirun");
  }
  return Perform(action, common, endAll);
}
} // namespace pixelexact
