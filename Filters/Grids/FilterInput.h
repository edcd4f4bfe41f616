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

// What filters do with their input: fields by name, its box, its leaf grids.

namespace pixelexact
{
/// The fields of these names; none: all, those that are defined by expressions, too. Throws as
/// HighOrderModel::GetField.
[[nodiscard]] std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names);

/// "Fields: u v", or "Fields: all": a line of PrintSelf.
void PrintFields(ostream& os, vtkIndent indent, const std::vector<std::string>& names);

/// The box (xmin, xmax, ymin, ymax, zmin, zmax) of the points of a grid, or of all blocks of
/// composite data.
[[nodiscard]] std::array<double, 6> BoundsOf(vtkDataObject* data);

// Filters whose output is of the input's type: a grid, or composite data of grids.

/// RequestDataObject: an output of the input's type.
void MakeOutputLikeInput(vtkInformationVector** input, vtkInformationVector* output);

/// Makes `output`, of the type of `input`, what `made` gives of the grid or of each leaf with
/// cells. Throws InvalidData where there is neither grid nor composite data, and with the leaf's
/// name what `made` throws.
void ForLeafGrids(vtkDataObject* input, vtkDataObject* output,
  const std::function<vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid*)>& made);
} // namespace pixelexact
#endif
