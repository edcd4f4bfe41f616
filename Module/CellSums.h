// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellSums_h
#define CellSums_h

#include "vtkType.h"

#include <span>

class vtkDataArray;
class vtkUnstructuredGrid;

// Sums replace a fingerprint where VTK merged points of several cells. Merged points agree up to
// rounding, but a hash of their bits differs. Weighted sums over a cell's points detect whether
// points or values are the same up to rounding, in the same order.
namespace pixelexact
{
/// Returns the number of sums for values with so many components.
constexpr int SumsFor(int components)
{
  return 1 + 2 * components;
}

/// Writes the sums of a cell: its type and number of points as one number, then two weighted sums
/// of each component of `values`, an array with one tuple per point.
void SumOver(
  vtkUnstructuredGrid* grid, vtkIdType cell, vtkDataArray* values, std::span<double> sums);

/// Whether two sets of sums belong to the same points. Each value may be off by `tolerance` and had
/// a magnitude of at most `largest` when it was summed.
bool AreSameSums(
  std::span<const double> a, std::span<const double> b, double tolerance, double largest);
} // namespace pixelexact
#endif
