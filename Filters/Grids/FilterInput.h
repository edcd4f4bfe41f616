// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterInput_h
#define FilterInput_h

#include "HighOrderModel.h"

#include "vtkIndent.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkInformationVector;

// Helpers for a filter's input: fields by name, bounding box, leaf grids.

namespace pixelexact
{
/// The fields of these names; all, those that expressions define included, where `names` is empty.
/// Throws as HighOrderModel::GetField.
[[nodiscard]] std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names);

/// "Fields: u v", or "Fields: all": a line of PrintSelf.
void PrintFields(ostream& os, vtkIndent indent, const std::vector<std::string>& names);

/// The box (xmin, xmax, ymin, ymax, zmin, zmax) of the points of a grid, or of all blocks of
/// composite data.
[[nodiscard]] std::array<double, 6> BoundsOf(vtkDataObject* data);

// Filters whose output is of the input's type: a grid, or composite data of grids.

/// Creates an output of the input's type, in RequestDataObject.
void MakeOutputLikeInput(vtkInformationVector** input, vtkInformationVector* output);

/// Sets `output`, of the type of `input`, to the results of `made` for the grid or for each leaf
/// with cells. Throws InvalidData where the input is neither a grid nor composite data. Exceptions
/// of `made` get the leaf's name.
void ForLeafGrids(vtkDataObject* input, vtkDataObject* output,
  const std::function<vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid*)>& made);
} // namespace pixelexact
#endif
