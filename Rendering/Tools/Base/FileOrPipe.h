// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <memory>
#include <string>

namespace pixelexact
{
/// Makes the folder `given`, where that is empty one in the current folder, named after the input
/// with `ending`. Throws Error where it cannot be made.
std::string MakeOutputFolder(
  const std::string& given, const std::string& input, const std::string& ending);

/// A stream that reads a file or a pipe once. Its state shows whether it could be opened. Throws
/// InvalidData where nothing is written to a pipe within five seconds.
std::unique_ptr<std::istream> OpenFileOrPipe(const std::string& path);
} // namespace pixelexact
