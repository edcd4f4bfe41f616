// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact::nektar
{
/// The files of one field or session: the file itself or, for a folder of a parallel run, its parts
/// and a field's Info.xml in the order of their names. Throws InvalidData for an empty folder.
std::vector<std::string> FileParts(const std::string& path);

/// The simulation time in a field file's metadata. Only the file's beginning is read.
std::optional<double> FieldTime(const std::string& path);

/// The names of the fields in a field file's first block; empty where the file's beginning does not
/// contain them.
std::vector<std::string> FieldNames(const std::string& path);

/// The HDF5 files that sessions name as their GEOMETRY and that are missing in `sessions`, where
/// they exist beside the session. For others the parser gives a message.
std::vector<std::string> MissingMeshes(const std::vector<NamedText>& sessions);
} // namespace pixelexact::nektar
