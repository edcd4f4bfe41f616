// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a GLVis stream, which holds a mesh and a grid function, as a mesh alone, and as a
// root file of a collection.
#include "Core/Base/Error.h"
#include "Formats/MFEM/Reader.h"
#include "Formats/MFEM/RootFile.h"

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
    else if (text.starts_with("{"))
    {
      pixelexact::mfem::ParseRootFile({ "input.mfem_root", text });
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
