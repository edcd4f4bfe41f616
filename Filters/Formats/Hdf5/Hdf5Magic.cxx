// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Hdf5/Hdf5File.h"

namespace pixelexact
{
bool IsHdf5(std::string_view bytes)
{
  return bytes.starts_with("\x89HDF\r\n");
}
} // namespace pixelexact
