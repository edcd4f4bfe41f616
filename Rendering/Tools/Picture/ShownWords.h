// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The option of a word: "--plane" of "--plane=z"; empty for a word that is none.
[[nodiscard]] std::string OptionOf(const std::string& word);

/// The state of a window or a page that differs from its command line.
struct ShownNow
{
  std::string surface; ///< "--plane=...", replaces the first one of its kind; empty: none
  CameraView view;
  std::optional<std::array<double, 2>> range; ///< of the colour map, where there is one
  std::optional<int> step;
  bool contours = false;
  bool edges = false;
  std::string output;
};

/// The words of render for a figure of the shown picture. `words`: those of view or serve, from
/// PrepareWords; `contours`: value of --contours where the words have none.
std::vector<std::string> WordsOf(const ShownNow& now, const std::vector<std::string>& words,
  const std::vector<std::string>& chosen, const std::string& contours);
} // namespace pixelexact
