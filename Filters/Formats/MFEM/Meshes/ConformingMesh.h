// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"

namespace pixelexact::mfem
{
/// Reads the sections of a mesh of version 1.0 to 1.3, whose elements are its leaves. Vertices that
/// no element has are dropped, but in `legacy` files. Throws InvalidData.
MeshFile ReadConforming(TextScanner& scanner, bool legacy);
} // namespace pixelexact::mfem
