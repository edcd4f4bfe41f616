// SPDX-License-Identifier: BSD-3-Clause
#ifndef ParallelRun_h
#define ParallelRun_h

#include "CompositeParts.h"
#include "PixelExactFiltersModule.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

// Filters in a parallel run. The requested pieces are the processes of the global controller, all
// of which update at the same time. Each process has the part of the mesh that the pipeline
// upstream gives it.

namespace pixelexact
{
/// The processes, where output is requested in a parallel run; null otherwise.
PIXELEXACTFILTERS_EXPORT vtkMultiProcessController* ProcessesThatShare(
  vtkInformationVector* output);

/// RequestUpdateExtent of filters that need all of the input: in a parallel run each process' part,
/// without ghosts; else all of it, whatever piece of the output is requested.
PIXELEXACTFILTERS_EXPORT void AskForParts(
  vtkInformationVector* input, vtkInformationVector* output);

/// Whether the input, or a leaf of it, is the part of one of several processes and has no cells.
/// The output of such a part is empty, without an error.
bool HasNoShare(vtkInformationVector* input);

/// RequestUpdateExtent: whether the input is composite data in a parallel run. VTK calls a filter
/// that takes no composite data once more for each leaf, as if the leaf were alone. `known` is the
/// result before that call and stays. Processes do not have the same leaves, so they cannot
/// exchange them.
bool ComesInBlocks(bool known, vtkInformationVector* input, vtkInformationVector* output);

/// The return value of RequestData: 0 on all processes where `answer` is 0 on any. Filters
/// downstream wait for all processes, and one that failed would not arrive. All processes must call
/// it.
PIXELEXACTFILTERS_EXPORT int AnswerOfAll(int answer, vtkInformationVector* output);

// Inputs of filters whose result covers the whole mesh, in a parallel run. All processes must call
// these functions.

class PIXELEXACTFILTERS_EXPORT WholeMesh
{
public:
  /// Which process makes the result: the first one, while the others' are empty, or each from its
  /// own input, for which all hold the whole mesh.
  enum class Maker
  {
    First,
    Each
  };
  explicit WholeMesh(Maker maker);

  /// RequestData: the input itself; in a parallel run the parts of all processes, one after the
  /// other, without ghosts; null on processes that make no result. Plain parts are converted, with
  /// warnings of `filter`. The parts are gathered again when any has changed. Throws Error on all
  /// processes where one fails.
  vtkDataObject* Of(
    vtkInformationVector* input, vtkInformationVector* output, vtkAlgorithm* filter);

private:
  void Gather(vtkDataObject* own, vtkMultiProcessController* processes, vtkAlgorithm* filter);

  Maker WhoMakes;
  DataState Source; ///< of this process' part
  vtkSmartPointer<vtkDataObject> Whole;
};

/// RequestData: a surface itself; in a parallel run the parts of all processes on the first
/// process, and null on the others.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkPolyData> WholeSurface(
  vtkPolyData* surface, vtkInformationVector* output);
} // namespace pixelexact
#endif
