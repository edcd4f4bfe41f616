// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelSource_h
#define ModelSource_h

#include "HighOrderModel.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>

class vtkAlgorithm;
class vtkUnstructuredGrid;

namespace pixelexact
{
class KeptMesh;

/// The model of a filter's input grid, which may carry coefficients or be a plain one; that is then
/// converted, and the conversion kept until the grid changes.
class ModelSource
{
public:
  ModelSource();
  ~ModelSource();

  /// Diagnostics of the conversion become warnings of `owner`. Throws Error.
  std::shared_ptr<HighOrderModel> Get(vtkUnstructuredGrid* grid, vtkAlgorithm* owner);

private:
  vtkSmartPointer<vtkUnstructuredGrid> Converted;
  const vtkUnstructuredGrid* Source = nullptr;
  vtkMTimeType SourceTime = 0;
  // Held until the next one is made, which may share its locator.
  std::shared_ptr<HighOrderModel> Model;
  std::unique_ptr<KeptMesh> Kept;
};
} // namespace pixelexact
#endif
