// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry.h"

namespace pixelexact::nektar
{
/// Reads CURVED into the geometry's curves and puts their numbers into its edges and faces.
void ReadCurves(const Document& document, const pugi::xml_node& curved, Geometry& geometry);
} // namespace pixelexact::nektar
