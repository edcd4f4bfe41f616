// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkLookupTable;

// Colour maps as ParaView exports them: JSON (a list of maps with RGBPoints) and XML (ColorMap
// elements with Points). Their points are spread over the range; opacities do not count.
namespace pixelexact
{
/// Whether a colour map's name is that of a file, ".json" or ".xml", optionally followed by
/// ":NAME".
bool NamesColorMapFile(const std::string& text);

/// A table as MakeColorMap's. Throws Error, naming the file, where it cannot be read, holds no map
/// of that name, or several where none is named; Unsupported for maps of categories.
vtkSmartPointer<vtkLookupTable> ReadColorMapFile(
  const std::string& text, const std::array<double, 2>& range);
} // namespace pixelexact
