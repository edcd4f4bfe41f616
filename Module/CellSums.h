// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellSums_h
#define CellSums_h

#include "vtkType.h"

#include <span>

class vtkDataArray;
class vtkUnstructuredGrid;

// What is left of a fingerprint where VTK made points of several cells one. Such points lie in one
// place up to rounding, but a hash of their bits is another. Sums with unequal weights over a
// cell's points tell whether they, or values there, are the same up to rounding, in the same order.
namespace pixelexact
{
/// For values of so many components.
constexpr int SumsFor(int components)
{
  return 1 + 2 * components;
}

/// Of a cell: its type and number of points as one number, and two weighted sums of each component
/// of `values`, an array with a tuple for each point.
void SumOver(
  vtkUnstructuredGrid* grid, vtkIdType cell, vtkDataArray* values, std::span<double> sums);

/// Whether sums are those of the same points, each of which may be off by `tolerance`, and was
/// summed at a size of at most `largest`.
bool AreSameSums(
  std::span<const double> a, std::span<const double> b, double tolerance, double largest);
} // namespace pixelexact
#endif
