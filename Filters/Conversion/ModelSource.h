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

/// Supplies the model of a filter's input: a grid with coefficients, a plain grid, or composite
/// data of such grids. Plain grids are converted, changes of grids with a solver's coefficients are
/// followed (FollowedGrid.h), and the result is kept until the grid changes.
class ModelSource
{
public:
  ModelSource();
  ~ModelSource();

  /// Returns the model of `data`. Diagnostics of the conversion become warnings of `owner`. Throws
  /// Error.
  std::shared_ptr<HighOrderModel> Get(vtkDataObject* data, vtkAlgorithm* owner);

  /// After Get: the data whose cells are the model's elements. For plain data this is another
  /// object than the input.
  [[nodiscard]] vtkDataObject* GridOf(vtkDataObject* data) const;

private:
  vtkSmartPointer<vtkDataObject> Convert(vtkUnstructuredGrid* grid, vtkAlgorithm* owner);
  vtkSmartPointer<vtkDataObject> Convert(vtkCompositeDataSet* data, vtkAlgorithm* owner);
  KeptMesh& Kept(std::size_t part);

  vtkSmartPointer<vtkDataObject> Converted;
  DataState Source; ///< of the data from which the model was made
  // Keeps the model until the next one exists, which may share its locator.
  std::shared_ptr<HighOrderModel> Model;
  std::vector<std::unique_ptr<KeptMesh>> Meshes; ///< by leaf
};

/// Whether the grid carries coefficients that fit it, and no array that could be a field as well,
/// so that a ModelSource takes it as it is.
[[nodiscard]] bool IsComplete(vtkUnstructuredGrid* grid);

/// Lets a port accept the data that a ModelSource accepts.
void TakeGrids(vtkInformation* port);
/// Returns `given` or, where it is empty, the name of the first array that the filter has to
/// process; empty where there is none.
std::string ChosenName(vtkAlgorithm* filter, const std::string& given);

/// Returns the grid itself where it has coefficients that fit, else a grid as ModelSource makes it.
/// Diagnostics become warnings of `owner`. Throws Error.
vtkSmartPointer<vtkUnstructuredGrid> WithCoefficients(
  vtkUnstructuredGrid* grid, vtkAlgorithm* owner);
} // namespace pixelexact
#endif
