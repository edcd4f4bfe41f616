// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include "Trace/Surfaces/Surface.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pixelexact
{
/// The cut-surfaces of the command line, in the order of their kinds in the help.
class SurfaceOptions
{
public:
  void AddTo(CLI::App& command);

  /// Throws UsageError when there is none or a number describes no surface, Error for a file that
  /// cannot be read, Unsupported for a surface that is declared but not available yet.
  [[nodiscard]] std::vector<std::shared_ptr<const Surface>> Make() const;

private:
  std::map<std::string, std::vector<std::vector<double>>> Numbers; ///< by option
  std::vector<std::string> Files;                                  ///< of triangles
  std::vector<std::string> Patches;                                ///< files of patches
  std::vector<std::string> NotYet; ///< names of the options given that are not available yet
  bool Boundary = false;
};
} // namespace pixelexact
