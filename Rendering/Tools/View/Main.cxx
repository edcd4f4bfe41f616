// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/CommandWords.h"
#include "Base/Help.h"
#include "Base/Options.h"
#include "Base/Report.h"
#include "Commands/ViewCommand.h"
#include "View/ViewWindow.h"

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>

// The window of `pixelexact view`, which starts it.
namespace
{
using namespace pixelexact;

int Fail(int status, const std::string& message)
{
  std::cerr << "pixelexact: " << message << '\n';
  return status;
}

int Run(const std::vector<std::string>& words)
{
  CLI::App program("The window of pixelexact view.", "pixelexact-view");
  AddHelp(program);
  program.set_version_flag("--version", "pixelexact " PIXELEXACT_VERSION);
  program.require_subcommand(1);
  CommonOptions common;
  common.words = words;
  Action action;
  const auto options = std::make_shared<RenderOptions>();
  std::vector<std::string> prepared;
  AddViewOptions(program, options, action,
    [&]
    {
      const char* display = std::getenv("DISPLAY");
      if (display == nullptr || *display == '\0')
      {
        throw UsageError("view: there is no display (DISPLAY is not set); use render");
      }
      std::optional<tbb::global_control> limit;
      if (common.threads > 0)
      {
        limit.emplace(
          tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(common.threads));
      }
      BeQuiet(common.quiet);
      ViewWindow(prepared).Show();
    });
  AddCommonOptions(*program.get_subcommand("view"), common);
  try
  {
    prepared = PrepareWords(program, words);
    std::vector<std::string> arguments = prepared;
    // CLI11 takes them from the back.
    std::ranges::reverse(arguments);
    program.parse(std::move(arguments));
    action();
  }
  catch (const CLI::ParseError& error)
  {
    return program.exit(error);
  }
  catch (const UsageError& error)
  {
    return Fail(2, error.what());
  }
  catch (const std::exception& error)
  {
    return Fail(1, error.what());
  }
  return 0;
}
} // namespace

int main(int argc, char** argv)
{
  try
  {
    return Run({ argv + 1, argv + argc });
  }
  catch (...)
  {
    std::fputs("pixelexact: internal error\n", stderr);
    return 1;
  }
}
