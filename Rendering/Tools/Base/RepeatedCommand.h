// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
/// The words of a command line, and those that were chosen.
struct RepeatedCommand
{
  std::vector<std::string> given;
  std::vector<std::string> chosen;

  /// That of the same picture.
  [[nodiscard]] std::vector<std::string> Words() const;
  /// The same for a shell.
  [[nodiscard]] std::string Text() const;
};
} // namespace pixelexact
