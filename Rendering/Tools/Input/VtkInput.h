// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Input.h"

// VTK's own formats, for FormatTable.cxx. They throw as ReadInput.
namespace pixelexact
{
/// .vtu and .pvtu: one, or the numbered ones of a time series.
InputGrid ReadXmlFiles(const InputRequest& request);
/// .pvd
InputGrid ReadXmlCollection(const InputRequest& request);
/// .vtkhdf, .hdf: one, which may have time steps, or the numbered ones of a time series.
InputGrid ReadVtkHdfFiles(const InputRequest& request);
/// .vtk
InputGrid ReadLegacyFile(const InputRequest& request);
} // namespace pixelexact
