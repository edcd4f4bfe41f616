// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Picture/RenderOptions.h"
#include "Scene/Shot.h"

#include <memory>
#include <string>
#include <vector>

namespace pixelexact
{
class ServedInput;

/// A command line of render, parsed and ready to be traced. Its options and its shot refer to each
/// other, so it stays where it is.
class ServedScene
{
public:
  /// `words`: of render, or of serve with the same options. `picture`: name of the file whose
  /// format is checked against the options. Throws UsageError and Error as render.
  ServedScene(
    const std::vector<std::string>& words, const std::string& picture, ServedInput& input);
  ~ServedScene();
  ServedScene(const ServedScene&) = delete;
  ServedScene& operator=(const ServedScene&) = delete;

  [[nodiscard]] const RenderOptions& GetOptions() const { return options_; }
  [[nodiscard]] const Shot& GetShot() const { return shot_; }

private:
  RenderOptions options_;
  std::shared_ptr<CLI::App> Program; ///< that the options refer to
  Shot shot_;
};

/// Parses render's options, for the command `words.front()`. Returns the program that they refer
/// to. Throws UsageError.
std::shared_ptr<CLI::App> ParseRender(
  const std::vector<std::string>& words, RenderOptions& options);
} // namespace pixelexact
