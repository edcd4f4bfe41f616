// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// Runs the command-line tool that is beside this program, without its table, and waits for it.
/// Whether it succeeded; what it says goes to stderr.
bool RunTool(const std::vector<std::string>& words);

/// What a window shows, beside what its command line said.
struct ShownNow
{
  std::string surface; ///< "--plane=...", in the place of the first one of its kind; empty: none
  CameraView view;
  std::optional<std::array<double, 2>> range; ///< of the colour map, where there is one
  std::optional<int> step;
  bool contours = false;
  bool edges = false;
  std::string output;
};

/// The words of render for the figure of what a window shows. `words`: of view, as PrepareWords
/// gives them; `contours`: of --contours where they do not say.
std::vector<std::string> WordsOf(const ShownNow& now, const std::vector<std::string>& words,
  const std::vector<std::string>& chosen, const std::string& contours);
} // namespace pixelexact
