// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry/Geometry.h"

namespace pixelexact::nektar
{
/// Adds the composites of solids and of faces to a geometry whose entities are complete. What
/// another part of the mesh has of the same composite is joined with it.
void ReadComposites(const Document& document, const pugi::xml_node& composites, Geometry& geometry);
} // namespace pixelexact::nektar
