// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry/Geometry.h"

namespace pixelexact::nektar
{
/// Adds the vertices, edges, faces and solids of a GEOMETRY to those of other parts of the mesh;
/// what is there already must be the same.
void ReadEntities(const Document& document, const pugi::xml_node& geometry,
  const Transform& transform, Geometry& target);
} // namespace pixelexact::nektar
