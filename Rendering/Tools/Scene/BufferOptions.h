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
/// The options of the file with each pixel's buffers.
class BufferOptions
{
public:
  void AddTo(CLI::App& added);

  /// Throws UsageError for names that are not arrays, or that belong to another option.
  void Check() const;

  [[nodiscard]] const std::string& File() const { return file_; }
  /// Names of the arrays; empty: all.
  [[nodiscard]] const std::vector<std::string>& Arrays() const { return Names; }
  /// The buffers that must be traced. Throws Error where one needs a field and there is none.
  [[nodiscard]] Buffer Needs(bool hasField) const;

private:
  const CLI::App* Command = nullptr;
  std::string file_;
  std::vector<std::string> Names;
};
} // namespace pixelexact
