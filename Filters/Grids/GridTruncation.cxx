// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridTruncation.h"

#include "HighOrderArrays.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

namespace pixelexact
{
vtkSmartPointer<vtkUnstructuredGrid> WithTruncated(
  vtkUnstructuredGrid* grid, std::span<const Truncation> truncations)
{
  auto output = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  output->ShallowCopy(grid);
  for (const Truncation& truncation : truncations)
  {
    const Field kept = truncation.Kept();
    std::vector<Space> spaces;
    spaces.reserve(static_cast<std::size_t>(kept.values.Elements()));
    for (int e = 0; e < kept.values.Elements(); ++e)
    {
      spaces.push_back(kept.values.SpaceOf(e));
    }
    ExpansionArrays arrays;
    arrays.Allocate(spaces, kept.values.components);
    arrays.mapping = kept.mapping;
    // Both lie element by element, component by component.
    std::ranges::copy(kept.values.coefficients, arrays.coefficients->GetPointer(0));
    StoreField(output, kept.name, arrays, Origin::Coefficients);
    output->GetPointData()->RemoveArray(kept.name.c_str());
    output->GetCellData()->RemoveArray(kept.name.c_str());
  }
  return output;
}
} // namespace pixelexact
