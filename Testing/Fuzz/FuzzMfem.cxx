// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a GLVis stream, which holds a mesh and a grid function, and as a mesh alone.
#include "Core/Base/Error.h"
#include "Formats/MFEM/Reader.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try
  {
    if (text.starts_with("MFEM"))
    {
      pixelexact::mfem::Read({ "input.mesh", text }, {});
    }
    else
    {
      pixelexact::mfem::ReadStream({ "input.saved", text });
    }
  }
  catch (const pixelexact::Error&)
  {
    // The answer that a bad file should get; anything else ends the process.
  }
  return 0;
}
