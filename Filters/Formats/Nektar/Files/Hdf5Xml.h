// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

namespace pixelexact::nektar
{
/// Nektar++'s HDF5 files, meshes (.nekg) and fields, as the XML that it would have written: numbers
/// stand in blocks of base64, bit by bit the same. Throws InvalidData and Unsupported.
std::string Hdf5AsXml(const NamedText& file);

/// The XML of a field file's metadata alone, read from disk.
std::string Hdf5Metadata(const std::string& path);
} // namespace pixelexact::nektar
