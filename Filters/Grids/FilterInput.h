// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterInput_h
#define FilterInput_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

class vtkDataObject;
class vtkInformationVector;

// Filters whose output is of the input's type: a grid, or composite data of grids.
namespace pixelexact
{
/// RequestDataObject: an output of the input's type.
void MakeOutputLikeInput(vtkInformationVector** input, vtkInformationVector* output);

/// Makes `output`, of the type of `input`, what `made` gives of the grid or of each leaf with
/// cells. Throws InvalidData where there is neither grid nor composite data, and with the leaf's
/// name what `made` throws.
void ForLeafGrids(vtkDataObject* input, vtkDataObject* output,
  const std::function<vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid*)>& made);
} // namespace pixelexact
#endif
