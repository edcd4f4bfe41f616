// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkType.h>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// The polynomial order (the highest of its directions) that a cell's type and number of points
/// give it; 0 where they tell none. The geometry may be of lower order: isoparametric files store
/// it at the field's.
int StoredOrder(vtkUnstructuredGrid& grid, vtkIdType cell);
} // namespace pixelexact
