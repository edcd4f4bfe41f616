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

/// For what is read once: a stream of a file, or of all that is written into a pipe. Its state says
/// whether it could be opened. Throws InvalidData where nobody writes within five seconds.
std::unique_ptr<std::istream> OpenFileOrPipe(const std::string& path);
} // namespace pixelexact
