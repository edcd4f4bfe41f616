// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/PointBounds.h"

#include "vtkCompositeDataSet.h"
#include "vtkUnstructuredGrid.h"

namespace pixelexact
{
std::array<double, 6> BoundsOf(vtkDataObject* data)
{
  std::array<double, 6> bounds;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    composite->GetBounds(bounds.data());
  }
  else
  {
    vtkUnstructuredGrid::SafeDownCast(data)->GetBounds(bounds.data());
  }
  return bounds;
}
} // namespace pixelexact
