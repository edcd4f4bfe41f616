// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkType.h>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// The polynomial order (the highest of its directions) that follows from a cell's type and number
/// of points; 0 where none follows. The geometry may be of lower order: isoparametric files store
/// it at the field's order.
int StoredOrder(vtkUnstructuredGrid& grid, vtkIdType cell);
} // namespace pixelexact
