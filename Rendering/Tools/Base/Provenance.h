// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pixelexact
{
/// The words of a command line, and the options that the program chose.
struct RepeatedCommand
{
  std::vector<std::string> given;
  std::vector<std::string> chosen;

  /// The words of a command that makes the same picture.
  [[nodiscard]] std::vector<std::string> Words() const;
  /// The same as text for a shell.
  [[nodiscard]] std::string Text() const;
};

/// Keys and texts that describe a picture in its file.
using PictureTexts = std::vector<std::pair<std::string, std::string>>;

/// The texts as lines, "Key: text".
std::string LinesOf(const PictureTexts& texts);

/// A line for each file: its name, size and XXH3-64 hash. Throws Error for one that cannot be read.
std::string DescribeFiles(const std::vector<std::string>& files);
/// The same files, and the files that collections (.pvd) and parallel files (.pvtu) name. Throws
/// Error for one that cannot be read.
std::vector<std::string> WithFilesBehind(const std::vector<std::string>& files);
} // namespace pixelexact
