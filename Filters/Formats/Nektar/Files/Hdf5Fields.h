// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
class Hdf5File;
}

namespace pixelexact::nektar
{
/// A field file of version 1 as XML.
std::string Hdf5Fields(const Hdf5File& file, const std::string& name);

/// Its metadata and the names of its fields alone, likewise.
std::string Hdf5FieldsHead(const Hdf5File& file, const std::string& name);
} // namespace pixelexact::nektar
