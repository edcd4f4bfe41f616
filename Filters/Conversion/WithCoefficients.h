// SPDX-License-Identifier: BSD-3-Clause
#ifndef WithCoefficients_h
#define WithCoefficients_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkAlgorithm;

namespace pixelexact
{
/// The grid itself where it carries coefficients; else one that was converted. Diagnostics of the
/// conversion become warnings of `owner`. Throws Error.
vtkSmartPointer<vtkUnstructuredGrid> WithCoefficients(
  vtkUnstructuredGrid* grid, vtkAlgorithm* owner);
} // namespace pixelexact
#endif
