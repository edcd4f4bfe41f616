// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/ViewCommand.h"

#include "Picture/RenderOptions.h"

#include "Core/Base/Error.h"

#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

// The window is a program of its own, pixelexact-view: this one needs neither OpenGL's factories
// nor a display.
namespace pixelexact
{
namespace
{
constexpr const char* kProgram = "pixelexact-view";

[[noreturn]] void Start(const std::vector<std::string>& words)
{
  std::error_code ignored;
  const std::filesystem::path beside =
    std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / kProgram;
  std::vector<std::string> copies{ kProgram };
  copies.insert(copies.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(copies.size() + 1);
  for (std::string& word : copies)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  execv(beside.c_str(), arguments.data());
  execvp(kProgram, arguments.data());
  throw Error(
    "view: its window is the program pixelexact-view, which is neither beside this one nor "
    "on the PATH; build it (PIXELEXACT_BUILD_VIEW), or use render");
}
} // namespace

void AddViewOptions(CLI::App& program, const std::shared_ptr<RenderOptions>& options,
  Action& action, const Action& perform)
{
  CLI::App& command = AddCommand(program, "view",
    "Look at a cut in a window, with render's options: drag the plane, read values, save the "
    "figure "
    "(h: help)",
    [options, &action, perform] { action = perform; });
  options->AddTo(command);
}

void AddViewCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  AddViewOptions(
    program, std::make_shared<RenderOptions>(), action, [&common] { Start(common.words); });
}
} // namespace pixelexact
