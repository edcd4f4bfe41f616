// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surfaces/MeshSurfaces.h"

#include <string>

// Surfaces of the command line that are made from the mesh.
namespace pixelexact
{
/// Parses "all", "ATTRIBUTE,..." or "element:NUMBER,...". Throws UsageError.
BoundaryChoice ParseBoundary(const std::string& text);

/// The parts of --isosurface. The last '=' precedes the value.
struct IsoText
{
  std::string name; ///< of a field, optionally followed by .magnitude or .COMPONENT
  double value = 0.0;
};
/// Parses --isosurface. Throws UsageError.
IsoText ParseIso(const std::string& text);

/// Finds the field and component of a name; the whole name of a field precedes a field with a
/// component. Throws Error where there is none.
IsoChoice Resolve(const IsoText& text, const HighOrderModel& model);
} // namespace pixelexact
