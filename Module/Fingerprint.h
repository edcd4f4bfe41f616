// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fingerprint_h
#define Fingerprint_h

#include "HighOrderArrays.h"

#include <cstdint>
#include <string>
#include <vector>

// 64-bit hashes that detect whether a cell or the values at its points changed after the
// coefficients were computed from them. A change goes unnoticed with a probability of about 2^-64
// per cell; the hashes guard against accidents, not against forgery. A hash is XXH3 (64 bits, no
// seed) of doubles as they lie in memory, -0 replaced by 0. Files of the first versions hold
// another hash, which is accepted.
namespace pixelexact
{
enum class Hash : std::uint8_t
{
  XXH3, ///< what is stored
  First ///< MurmurHash3's finaliser (A. Appleby, public domain), word by word
};

/// Returns a hash per cell of its type, its number of points and their coordinates, in this order,
/// all as doubles (so that float points may be stored as double).
std::vector<std::int64_t> CellFingerprints(vtkUnstructuredGrid* grid, Hash hash = Hash::XXH3);

/// Returns a hash per cell of the values of `source` at its points, in order (IsAtPoints), or of
/// the cell's own value.
std::vector<std::int64_t> ValueFingerprints(
  vtkUnstructuredGrid* grid, vtkDataArray* source, Origin origin, Hash hash = Hash::XXH3);

/// Returns the array that holds values of a field of this name and origin: the nodal values that
/// the field was computed from, or those that represent a solver's field; null where there is none.
vtkDataArray* FieldSource(vtkUnstructuredGrid* grid, const std::string& name, Origin origin);
} // namespace pixelexact
#endif
