// SPDX-License-Identifier: BSD-3-Clause
#ifndef StaleArrays_h
#define StaleArrays_h

#include "PixelExactDataModelModule.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkUnstructuredGrid;

// Finds what filters have changed of a grid since its coefficients were stored (HighOrderArrays.h).
namespace pixelexact
{
struct StaleParts
{
  bool cells = false;              ///< a cell's type or points
  std::vector<std::string> fields; ///< names of fields whose array has other values

  [[nodiscard]] bool Any() const { return cells || !fields.empty(); }
};

/// Compares the fingerprints of a grid whose coefficients are not packed. Throws as
/// HighOrderModel::From where cells do not name elements, or where arrays are missing or damaged.
[[nodiscard]] PIXELEXACTDATAMODEL_EXPORT StaleParts FindStaleParts(vtkUnstructuredGrid* grid);

/// A shallow copy of the grid in which stale coefficients count as those of its cells and arrays as
/// they are now. Throws as FindStaleParts.
[[nodiscard]] PIXELEXACTDATAMODEL_EXPORT vtkSmartPointer<vtkUnstructuredGrid>
WithPresentFingerprints(vtkUnstructuredGrid* grid, const StaleParts& stale);
} // namespace pixelexact
#endif
