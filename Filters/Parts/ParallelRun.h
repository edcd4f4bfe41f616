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

// Filters in a parallel run: the pieces that are asked for are the processes of the global
// controller, all of which update at the same time, and each has a part of the mesh that only what
// is upstream knows.

namespace pixelexact
{
/// The processes, where output is asked for in such a run; null elsewhere.
PIXELEXACTFILTERS_EXPORT vtkMultiProcessController* ProcessesThatShare(
  vtkInformationVector* output);

/// RequestUpdateExtent of what needs all of the input: in a parallel run each process' part,
/// without ghosts; else all of it, whatever piece of the output is asked for.
PIXELEXACTFILTERS_EXPORT void AskForParts(
  vtkInformationVector* input, vtkInformationVector* output);

/// Whether the input, or a leaf of it, is the part of one of several processes, and has no cells.
/// What is made of it is empty, and no error.
bool HasNoShare(vtkInformationVector* input);

/// RequestUpdateExtent: whether the input is composite data in a parallel run. A filter that takes
/// none is then asked for each leaf, once more and as if it were alone, which changes nothing:
/// `known` is what it gave before. Processes have not the same leaves, and cannot exchange them.
bool ComesInBlocks(bool known, vtkInformationVector* input, vtkInformationVector* output);

/// What RequestData returns: 0 on all processes where `answer` is 0 on any. Filters behind wait for
/// all of them, and one that failed would not come. All processes must call it.
PIXELEXACTFILTERS_EXPORT int AnswerOfAll(int answer, vtkInformationVector* output);

// What filters whose result is of all of the mesh get in a parallel run. All processes must call
// what follows.

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
