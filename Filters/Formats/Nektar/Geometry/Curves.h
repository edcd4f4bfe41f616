// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry/Geometry.h"

namespace pixelexact::nektar
{
/// Reads CURVED into the geometry's curves, their points moved as its vertices are, and puts their
/// numbers into its edges and faces.
void ReadCurves(const Document& document, const pugi::xml_node& curved, const Transform& transform,
  Geometry& geometry);
} // namespace pixelexact::nektar
