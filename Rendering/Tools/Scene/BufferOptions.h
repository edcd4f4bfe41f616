// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// What was found at each pixel, for a file: which of it.
class BufferOptions
{
public:
  void AddTo(CLI::App& added);

  /// Throws UsageError for names that are of no array, or of one that another option makes.
  void Check() const;

  [[nodiscard]] const std::string& File() const { return file_; }
  /// Names of arrays; empty: all that there are.
  [[nodiscard]] const std::vector<std::string>& Arrays() const { return Names; }
  /// The buffers to be traced for it. Throws Error where one needs a field and there is none.
  [[nodiscard]] Buffer Needs(bool hasField) const;

private:
  const CLI::App* Command = nullptr;
  std::string file_;
  std::vector<std::string> Names;
};
} // namespace pixelexact
