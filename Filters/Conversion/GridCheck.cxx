// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/GridCheck.h"
#include "Cells/CellStorage.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>

namespace pixelexact
{
void CheckConsistency(vtkUnstructuredGrid& grid)
{
  const vtkIdType points = grid.GetNumberOfPoints();
  const vtkIdType cells = grid.GetNumberOfCells();
  // A file that ends before its cells leaves none of the arrays.
  if (vtkCellArray* connectivity = cells > 0 ? grid.GetCells() : nullptr)
  {
    if (CellTypeCount(grid) != cells)
    {
      throw InvalidData("the numbers of cells and of cell types differ");
    }
    if (!connectivity->IsValid())
    {
      throw InvalidData("the offsets of its cells do not fit their list of points");
    }
    vtkIdType cell = 0;
    const auto iterator = vtk::TakeSmartPointer(connectivity->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
         iterator->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(count, ids);
      if (std::any_of(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; }))
      {
        throw InvalidData(
          "cell " + std::to_string(cell) + " has a point that the file does not hold");
      }
    }
  }
  const auto checkArrays = [](vtkDataSetAttributes& data, vtkIdType expected, const char* what)
  {
    for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    {
      const vtkAbstractArray* array = data.GetAbstractArray(i);
      if (array->GetNumberOfTuples() != expected)
      {
        const char* name = data.GetArrayName(i);
        throw InvalidData(std::string(what) + " array '" + (name != nullptr ? name : "") +
          "' holds " + Counted(array->GetNumberOfTuples(), "value") + " for " +
          Counted(expected, what));
      }
    }
  };
  checkArrays(*grid.GetPointData(), points, "point");
  checkArrays(*grid.GetCellData(), cells, "cell");
}
} // namespace pixelexact
