// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pixelexact::nektar
{
/// The files that make up one field file: itself, or where it is a folder (as parallel runs write
/// it) Info.xml and the parts, in the order of their names. Throws InvalidData for an empty folder.
std::vector<std::string> FieldParts(const std::string& path);

/// The simulation time in the metadata of a field file, read from its beginning only.
std::optional<double> FieldTime(const std::string& path);
} // namespace pixelexact::nektar
