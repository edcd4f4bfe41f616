// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
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

/// What a picture's file says of itself: keys and texts.
using PictureTexts = std::vector<std::pair<std::string, std::string>>;

/// The texts as lines, "Key: text".
std::string LinesOf(const PictureTexts& texts);

/// A line for each file: its name, size and XXH3-64 hash. Throws Error for one that cannot be read.
std::string DescribeFiles(const std::vector<std::string>& files);
/// The same files, and those that they name: of collections (.pvd) and parallel files (.pvtu).
/// Throws Error for one that cannot be read.
std::vector<std::string> WithFilesBehind(const std::vector<std::string>& files);
} // namespace pixelexact
