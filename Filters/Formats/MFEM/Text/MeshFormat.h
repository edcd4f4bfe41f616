// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Text/TextScanner.h"

#include <cstdint>
#include <string>

// What a mesh file's first lines tell of it, and what is refused of whole files.
namespace pixelexact::mfem
{
enum class MeshFormat : std::uint8_t
{
  Conforming,
  Legacy, ///< v1.1: numbered as it stands
  Inline, ///< a box, by its numbers
  Nonconforming,
  NonconformingScaled, ///< NC v1.1: vertices anywhere between their parents
  Nurbs,
  NurbsSpaced ///< NURBS v1.1: says how to refine, too
};

/// Reads the first line. Throws Unsupported for kinds and versions that are not read, InvalidData
/// for what is no MFEM mesh.
MeshFormat ReadMeshFormat(TextScanner& scanner);

/// Reads the dimension of the elements, 2 or 3; throws Unsupported for others.
int ReadDimension(TextScanner& scanner);

/// Reads the dimension of the vertices' space, not below the elements'; throws as ReadDimension.
int ReadSpaceDimension(TextScanner& scanner, int dimension);

/// Throws InvalidData: the file holds a piece of the mesh of so many processes, of which so many
/// are read.
[[noreturn]] void RefusePiece(const TextScanner& scanner, int processes, int pieces);
} // namespace pixelexact::mfem
