// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelSource_h
#define ModelSource_h

#include "CompositeParts.h"
#include "HighOrderModel.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnstructuredGrid.h"

#include <memory>
#include <vector>

class vtkAlgorithm;
class vtkCompositeDataSet;
class vtkDataObject;
class vtkInformation;

namespace pixelexact
{
class KeptMesh;

/// The model of a filter's input: a grid, which may carry coefficients or be a plain one; that is
/// then converted, and the conversion kept until the grid changes. Or composite data of such grids.
class ModelSource
{
public:
  ModelSource();
  ~ModelSource();

  /// Diagnostics of the conversion become warnings of `owner`. Throws Error.
  std::shared_ptr<HighOrderModel> Get(vtkDataObject* data, vtkAlgorithm* owner);

  /// After Get: the data whose cells are the model's elements, which of plain data is another
  /// object.
  [[nodiscard]] vtkDataObject* GridOf(vtkDataObject* data) const;

private:
  vtkSmartPointer<vtkDataObject> Convert(vtkUnstructuredGrid* grid, vtkAlgorithm* owner);
  vtkSmartPointer<vtkDataObject> Convert(vtkCompositeDataSet* data, vtkAlgorithm* owner);
  KeptMesh& Kept(std::size_t part);

  vtkSmartPointer<vtkDataObject> Converted;
  DataState Source; ///< that it was made of
  // Held until the next one is made, which may share its locator.
  std::shared_ptr<HighOrderModel> Model;
  std::vector<std::unique_ptr<KeptMesh>> Meshes; ///< by leaf
};

/// A port that takes what a ModelSource does.
void TakeGrids(vtkInformation* port);
/// The name that is given, else that of the first array that the filter is told to process; empty
/// where there is neither.
std::string ChosenName(vtkAlgorithm* filter, const std::string& given);

/// The grid itself where it carries coefficients; else one that was converted. Diagnostics of the
/// conversion become warnings of `owner`. Throws Error.
vtkSmartPointer<vtkUnstructuredGrid> WithCoefficients(
  vtkUnstructuredGrid* grid, vtkAlgorithm* owner);
} // namespace pixelexact
#endif
