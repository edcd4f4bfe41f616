// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fingerprint_h
#define Fingerprint_h

#include "HighOrderArrays.h"

#include <cstdint>
#include <string>
#include <vector>

// 64-bit hashes that tell whether a cell and the values at its points are still those from which
// coefficients were made. A change goes unnoticed with a probability of about 2^-64 per cell; they
// guard against accidents, not against forgery. A hash is XXH3 (64 bits, no seed) of doubles as
// they lie in memory, -0 replaced by 0. Files of the first versions hold another hash, which is
// honoured.
namespace pixelexact
{
enum class Hash : std::uint8_t
{
  XXH3, ///< what is stored
  First ///< MurmurHash3's finaliser (A. Appleby, public domain), word by word
};

/// Per cell, in this order: type, number of points and the coordinates of its points, all as
/// doubles (so that float points may be stored as double).
std::vector<std::int64_t> CellFingerprints(vtkUnstructuredGrid* grid, Hash hash = Hash::XXH3);

/// Per cell: the values of `source` at its points, in order, or its own (IsAtPoints).
std::vector<std::int64_t> ValueFingerprints(
  vtkUnstructuredGrid* grid, vtkDataArray* source, Origin origin, Hash hash = Hash::XXH3);

/// The array that holds values of a field of this name and origin: those it was made from, or those
/// that show a solver's field; null where it is not there.
vtkDataArray* FieldSource(vtkUnstructuredGrid* grid, const std::string& name, Origin origin);
} // namespace pixelexact
#endif
