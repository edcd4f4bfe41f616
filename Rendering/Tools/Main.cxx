// SPDX-License-Identifier: BSD-3-Clause
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
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <optional>

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
  if (!pixelexact::IsFirstProcess())
  {
    return status; // the first one says the same
  }
  std::cerr << "pixelexact: " << message << '\n';
  if (json)
  {
    pixelexact::PrintError(message);
  }
  return status;
}

/// Reports a failure of this process only, and ends all processes, which may wait for this one.
int FailAlone(const std::string& message, bool json)
{
  if (!pixelexact::IsFirstProcess())
  {
    std::cerr << "pixelexact: process " << pixelexact::ProcessNumber() << ": " << message << '\n';
  }
  const int status = Fail(kWorkFailed, message, json);
  pixelexact::EndAllProcesses(status);
  return status;
}

/// The exit status after success, unless printed output was lost.
int Done()
{
  try
  {
    pixelexact::FlushOutput();
  }
  catch (const pixelexact::Error& error)
  {
    return Fail(kWorkFailed, error.what(), false);
  }
  return kDone;
}

/// Runs the command.
int Perform(const pixelexact::Action& action, const pixelexact::CommonOptions& common)
{
  std::optional<tbb::global_control> limit;
  if (common.threads > 0)
  {
    limit.emplace(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(common.threads));
  }
  pixelexact::BeQuiet(common.quiet || !pixelexact::IsFirstProcess());
  try
  {
    action();
    return Done();
  }
  catch (const pixelexact::UsageError& error)
  {
    return Fail(kWrongUsage, error.what(), common.json);
  }
  catch (const pixelexact::Error& error)
  {
    return Fail(kWorkFailed, error.what(), common.json);
  }
  catch (const std::bad_alloc&)
  {
    return FailAlone("out of memory", common.json);
  }
  catch (const std::exception& error)
  {
    return FailAlone(error.what(), common.json);
  }
}

int Run(std::vector<std::string> words)
{
  CLI::App program("Pixel-exact pictures of high-order finite-element fields.", "pixelexact");
  pixelexact::AddHelp(program);
  program.set_version_flag("--version", "pixelexact " PIXELEXACT_VERSION);
  program.require_subcommand(1);
  program.footer(kFooter);

  pixelexact::CommonOptions common;
  pixelexact::Action action;
  pixelexact::AddInfoCommand(program, common, action);
  pixelexact::AddProbeCommand(program, common, action);
  pixelexact::AddRenderCommand(program, common, action);
  pixelexact::AddBenchCommand(program, common, action);
  pixelexact::AddCompareCommand(program, common, action);
  pixelexact::AddIntegrateCommand(program, common, action);
  pixelexact::AddViewCommand(program, common, action);
  pixelexact::AddServeCommand(program, common, action);
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
  {
    pixelexact::AddCommonOptions(*command, common);
    command->set_version_flag("--version", "pixelexact " PIXELEXACT_VERSION);
  }

  const auto misused = [&](const std::string& message)
  {
    const std::string command = pixelexact::CommandOf(program, words);
    const bool json = std::ranges::find(words, "--json") != words.end();
    return Fail(kWrongUsage,
      message + "; see pixelexact " + command + (command.empty() ? "" : " ") + "--help", json);
  };
  try
  {
    if (words.size() == 2 && words.front() == "--completion")
    {
      std::cout << pixelexact::GeneratedText(program, words.back());
      return Done();
    }
    words = pixelexact::WithDefaults(program, words);
    common.words = words;
    std::vector<std::string> arguments = pixelexact::PrepareWords(program, words);
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
  catch (const pixelexact::UsageError& error)
  {
    return misused(error.what());
  }
  if (pixelexact::AreSeveralProcesses() && pixelexact::CommandOf(program, words) != "render")
  {
    return misused("this command is for one process; start it without mpirun");
  }
  return Perform(action, common);
}
} // namespace

int main(int argc, char** argv)
{
  try
  {
    const pixelexact::ProgramProcesses processes(&argc, &argv);
    return Run({ argv + 1, argv + argc });
  }
  catch (const pixelexact::Error& error)
  {
    return Fail(kWrongUsage, error.what(), false);
  }
  catch (...)
  {
    // Perform handles the exceptions of commands; this one is unexpected.
    std::fputs("pixelexact: internal error\n", stderr);
    return kWorkFailed;
  }
}
