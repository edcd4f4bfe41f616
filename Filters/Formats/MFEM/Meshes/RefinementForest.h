// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"

namespace pixelexact::mfem
{
/// Reads the body of an "MFEM NC mesh": the forest of refined elements, whose leaves are the
/// elements. They are put in MFEM's order (along space-filling curves in fully refined cubes), and
/// so are the vertices: those of the coarsest level first. `scaled`: version 1.1, whose vertices
/// need not halve their parents' edge.
MeshFile ReadNonconforming(TextScanner& scanner, bool scaled);
} // namespace pixelexact::mfem
