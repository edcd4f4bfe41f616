// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pixelexact
{
/// The files in the folder of a file that have a suffix (".gf"), sorted by name; none where the
/// folder cannot be read.
std::vector<std::filesystem::path> FilesBeside(
  const std::filesystem::path& file, const std::string& suffix);

/// The number N of a name `stem_N`; -1 where it is none.
int NumberBehind(const std::string& name, const std::string& stem);

/// A name without the number after its last underscore.
std::string WithoutNumber(const std::string& name);
} // namespace pixelexact
