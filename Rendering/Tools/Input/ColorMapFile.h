// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Volume/TransferFunction.h"

#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkLookupTable;

// Colour maps as ParaView exports them: JSON (a list of maps with RGBPoints) and XML (ColorMap
// elements with Points). For surfaces their points are spread over the range, without opacities.
namespace pixelexact
{
/// Whether a colour map's name is that of a file, ".json" or ".xml", optionally followed by
/// ":NAME".
bool NamesColorMapFile(const std::string& text);

/// A table as MakeColorMap's. Throws Error, naming the file, where it cannot be read, holds no map
/// of that name, or several where none is named; Unsupported for maps of categories.
vtkSmartPointer<vtkLookupTable> ReadColorMapFile(
  const std::string& text, const std::array<double, 2>& range);

/// Colours and opacities at the values that the file gives. Opacities have VTK's meaning: linear,
/// or with sharpness 1 a step, at the midpoint; without any they rise from 0 to 1 over the colours.
/// Colours of other spaces than RGB become 64 linear parts. `unit`: see TransferFunction. Throws
/// as above, and Unsupported for other sharpnesses and for the space Step.
TransferFunction ReadTransferFile(const std::string& text, double unit);
} // namespace pixelexact
