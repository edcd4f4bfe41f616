// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/Hdf5/Hdf5File.h"

#include <string>

namespace pixelexact::nektar
{
/// Converts Nektar++'s HDF5 files, meshes (.nekg) and fields, to the XML that Nektar++ would have
/// written. Numbers are in blocks of base64, bitwise equal. Throws InvalidData and Unsupported.
std::string Hdf5AsXml(const NamedText& file);

/// The XML of a field file's metadata alone, read from disk.
std::string Hdf5Metadata(const std::string& path);

/// A field file of version 1 as XML.
std::string Hdf5Fields(const Hdf5File& file, const std::string& name);

/// Its metadata and the names of its fields alone, likewise.
std::string Hdf5FieldsHead(const Hdf5File& file, const std::string& name);
} // namespace pixelexact::nektar
