// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

// One file per command. Each declares its options and, when the command line names it, stores the
// work in `action`; Main.cxx runs it and turns exceptions into an exit status.
namespace pixelexact
{
/// An error of the command line alone: exit status 2. Errors that depend on the input are of class
/// Error: exit status 1.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

using Action = std::function<void()>;

/// Options of all commands.
struct CommonOptions
{
  int threads = 0; ///< 0: number of the machine's threads
  bool json = false;
  bool quiet = false;
  std::string config;             ///< a file of defaults (Defaults.h); empty: the default one
  bool noConfig = false;          ///< no defaults
  std::vector<std::string> words; ///< the command line and its defaults, without the program's name
};
void AddCommonOptions(CLI::App& command, CommonOptions& options);

void AddInfoCommand(CLI::App& program, const CommonOptions& common, Action& action);
void AddProbeCommand(CLI::App& program, const CommonOptions& common, Action& action);
void AddRenderCommand(CLI::App& program, const CommonOptions& common, Action& action);
void AddBenchCommand(CLI::App& program, const CommonOptions& common, Action& action);
void AddCompareCommand(CLI::App& program, const CommonOptions& common, Action& action);
void AddIntegrateCommand(CLI::App& program, const CommonOptions& common, Action& action);
void AddViewCommand(CLI::App& program, const CommonOptions& common, Action& action);
void AddServeCommand(CLI::App& program, const CommonOptions& common, Action& action);
} // namespace pixelexact
