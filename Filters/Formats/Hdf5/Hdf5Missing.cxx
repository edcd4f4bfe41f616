// SPDX-License-Identifier: BSD-3-Clause
// Replaces Hdf5Library.cxx where there is no HDF5 library.
#include "Formats/Hdf5/Hdf5File.h"

#include "Core/Base/Error.h"

namespace pixelexact
{
namespace
{
[[noreturn]] void Refuse(const std::string& name)
{
  throw Unsupported(name +
    ": this is an HDF5 file, and the program was built without the HDF5 library; install it "
    "(Debian: libhdf5-dev) and build again, or write the file as XML.");
}
} // namespace

std::unique_ptr<Hdf5File> OpenHdf5(const std::string& name, std::string_view /*bytes*/)
{
  Refuse(name);
}

std::unique_ptr<Hdf5File> OpenHdf5(const std::string& path)
{
  Refuse(path);
}
} // namespace pixelexact
