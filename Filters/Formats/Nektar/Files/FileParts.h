// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact::nektar
{
/// The files that make up one field or session file: itself, or where it is a folder (as parallel
/// runs write it) the parts and a field's Info.xml, in the order of their names. Throws InvalidData
/// for an empty folder.
std::vector<std::string> FileParts(const std::string& path);

/// The simulation time in the metadata of a field file, read from its beginning only.
std::optional<double> FieldTime(const std::string& path);

/// The names of the fields in a field file, as its first block gives them; none where its beginning
/// does not tell.
std::vector<std::string> FieldNames(const std::string& path);

/// The HDF5 files that sessions name as their GEOMETRY and that are not among them, where they lie
/// beside the session. Those that do not are left to the parser's message.
std::vector<std::string> MissingMeshes(const std::vector<NamedText>& sessions);
} // namespace pixelexact::nektar
