// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/WithCoefficients.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/GridConversion.h"
#include "HighOrderArrays.h"

#include "vtkAlgorithm.h"

namespace pixelexact
{
vtkSmartPointer<vtkUnstructuredGrid> WithCoefficients(
  vtkUnstructuredGrid* grid, vtkAlgorithm* owner)
{
  if (HasHighOrderArrays(grid))
  {
    return grid;
  }
  auto converted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  KeptMesh kept;
  for (const auto& line : ConvertGrid(grid, {}, kept, converted).diagnostics)
  {
    vtkWarningWithObjectMacro(owner, << line);
  }
  return converted;
}
} // namespace pixelexact
