// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"

namespace pixelexact::mfem
{
/// Reads what follows "MFEM INLINE": "type = quad", "nx = 4", "sx = 1.0" and so on, and makes the
/// box of squares, triangles, cubes, prisms, pyramids or tetrahedra that MFEM makes, with its
/// attributes. MFEM numbers squares and cubes along a space-filling curve, here they are in rows:
/// the mesh is not `isNumbered`. Throws InvalidData, and Unsupported for segments.
MeshFile ReadInline(TextScanner& scanner);
} // namespace pixelexact::mfem
