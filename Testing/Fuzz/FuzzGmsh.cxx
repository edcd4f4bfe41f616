// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a Gmsh file and, behind a line that separates them, a file of views, or another
// partition of the mesh.
#include "Core/Base/Error.h"
#include "Formats/Gmsh/Reader.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::string_view kSeparator = "\n---- view file ----\n";
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto at = text.find(kSeparator);
  std::vector<pixelexact::NamedText> files{ { "input.msh", text.substr(0, at) } };
  if (at != std::string_view::npos)
  {
    files.push_back({ "view.msh", text.substr(at + kSeparator.size()) });
  }
  try
  {
    pixelexact::gmsh::ReadTimes(files);
    pixelexact::gmsh::Read(files);
  }
  catch (const pixelexact::Error&)
  {
    // The answer that a bad file should get; anything else ends the process.
  }
  try
  {
    pixelexact::gmsh::Read(files, 0, true, 1, true);
  }
  catch (const pixelexact::Error&)
  {
    // As above.
  }
  try
  {
    if (files.size() > 1)
    {
      pixelexact::gmsh::Read(files, 0, true, files.size());
    }
  }
  catch (const pixelexact::Error&)
  {
    // As above.
  }
  return 0;
}
