// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surfaces/MeshSurfaces.h"

#include <string>

// Surfaces of the command line that are made of the mesh.
namespace pixelexact
{
/// "all", "ATTRIBUTE,..." or "element:NUMBER,...". Throws UsageError.
BoundaryChoice ParseBoundary(const std::string& text);

/// What --isosurface was given: the last '=' stands before the value.
struct IsoText
{
  std::string name; ///< of a field, or of one with .magnitude or .COMPONENT behind it
  double value = 0.0;
};
/// Throws UsageError.
IsoText ParseIso(const std::string& text);

/// The field and component that the name is of: a field's whole name goes before a component.
/// Throws Error where there is none.
IsoChoice Resolve(const IsoText& text, const HighOrderModel& model);
} // namespace pixelexact
