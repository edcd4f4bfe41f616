// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/TextScanner.h"

#include <string>

// What a mesh file's first lines tell of it, and what is refused of whole files.
namespace pixelexact::mfem
{
enum class MeshFormat : std::uint8_t
{
  Conforming,
  Legacy, ///< v1.1: numbered as it stands
  Nonconforming,
  NonconformingScaled ///< NC v1.1: vertices anywhere between their parents
};

/// Reads the first line. Throws Unsupported for kinds and versions that are not read, InvalidData
/// for what is no MFEM mesh.
MeshFormat ReadMeshFormat(TextScanner& scanner);

/// Reads the dimension of the elements, 2 or 3; throws Unsupported for others.
int ReadDimension(TextScanner& scanner);

/// Reads the dimension of the vertices' space, not below the elements'; throws as ReadDimension.
int ReadSpaceDimension(TextScanner& scanner, int dimension);

/// Throws Unsupported: the file holds one piece of a mesh, by this sign.
[[noreturn]] void RefusePiece(const TextScanner& scanner, const std::string& sign);

/// A file that seems to hold another piece of the same parallel mesh as `path`, by their names
/// ("x.000000", "x.000001"); empty where there is none.
std::string OtherPiece(const std::string& path);
} // namespace pixelexact::mfem
