// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/Hdf5/Hdf5File.h"

#include <string>

namespace pixelexact::nektar
{
/// Nektar++'s HDF5 files, meshes (.nekg) and fields, as the XML that it would have written: numbers
/// stand in blocks of base64, bit by bit the same. Throws InvalidData and Unsupported.
std::string Hdf5AsXml(const NamedText& file);

/// The XML of a field file's metadata alone, read from disk.
std::string Hdf5Metadata(const std::string& path);

/// A field file of version 1 as XML.
std::string Hdf5Fields(const Hdf5File& file, const std::string& name);

/// Its metadata and the names of its fields alone, likewise.
std::string Hdf5FieldsHead(const Hdf5File& file, const std::string& name);
} // namespace pixelexact::nektar
