// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
/// A file's whole content, gunzipped where it is compressed. Throws InvalidData (no such file, a
/// folder, unreadable, damaged, or decompressing to more than 200 times its size).
std::string ReadFileText(const std::string& path);
} // namespace pixelexact
