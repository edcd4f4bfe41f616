// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeMesh_h
#define WholeMesh_h

#include "CompositeParts.h"
#include "PixelExactFiltersModule.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <functional>

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

// What filters whose result is of all of the mesh get in a parallel run (ParallelRun.h). All
// processes must call what is here.
namespace pixelexact
{
class PIXELEXACTFILTERS_EXPORT WholeMesh
{
public:
  /// Who makes the result: the first process, and the others' are empty; or each of its own input,
  /// for which all hold the whole mesh.
  enum class Maker
  {
    First,
    Each
  };
  explicit WholeMesh(Maker maker);

  /// RequestData: the input itself, and in a parallel run the parts of all processes, one after the
  /// other, without ghosts; null on processes that make no result. Plain parts are converted, with
  /// warnings of `filter`. Made anew when any part has changed. Throws Error, and then on all.
  vtkDataObject* Of(
    vtkInformationVector* input, vtkInformationVector* output, vtkAlgorithm* filter);

  /// RequestData of a filter that fills its output by make(mesh), with what Of gives; where that is
  /// null, or make gives false, for it was aborted, it is empty. What throws is the filter's error.
  int Fill(vtkAlgorithm* filter, vtkInformationVector* input, vtkInformationVector* output,
    const std::function<bool(vtkDataObject* mesh)>& make);

private:
  void Gather(vtkDataObject* own, vtkMultiProcessController* processes, vtkAlgorithm* filter);

  Maker WhoMakes;
  DataState Source; ///< of this process' part
  vtkSmartPointer<vtkDataObject> Whole;
};

/// RequestData: a surface itself, and in a parallel run the parts of all processes; null but on the
/// first one.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkPolyData> WholeSurface(
  vtkPolyData* surface, vtkInformationVector* output);
} // namespace pixelexact
#endif
