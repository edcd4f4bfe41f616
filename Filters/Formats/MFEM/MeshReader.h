// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"

namespace pixelexact::mfem
{
/// Reads a mesh of any version; what follows it stays in the scanner. Throws InvalidData and
/// Unsupported.
MeshFile ReadMesh(TextScanner& scanner);
} // namespace pixelexact::mfem
