// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
/// Makes the folder `given`, where that is empty one in the current folder, named after the input
/// with `ending`. Throws Error where it cannot be made.
std::string MakeOutputFolder(
  const std::string& given, const std::string& input, const std::string& ending);
} // namespace pixelexact
