// SPDX-License-Identifier: BSD-3-Clause
#ifndef OutputGrid_h
#define OutputGrid_h

#include "Conversion/SourceMesh.h"

namespace pixelexact
{
/// Makes `output` a grid of the elements' cells alone, with all points and all data of the input
/// but without coefficients of any earlier conversion. Arrays are shared where no cell is left out.
void CopyElements(vtkUnstructuredGrid* input, const SourceMesh& mesh, vtkUnstructuredGrid* output);

/// Whether the grid carries coefficients from a solver's own file, which a conversion from nodal
/// values could only lose.
bool HasSolverCoefficients(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
