// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <memory>
#include <string>

namespace pixelexact
{
/// For what is read once: a stream of a file, or of all that is written into a pipe. Its state says
/// whether it could be opened. Throws InvalidData where nobody writes within five seconds.
std::unique_ptr<std::istream> OpenFileOrPipe(const std::string& path);
} // namespace pixelexact
