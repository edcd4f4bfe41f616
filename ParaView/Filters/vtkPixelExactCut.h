// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactCut
 * @brief   base of PixelExact Slice and PixelExact Clip: a filter with a function that cuts
 *
 * The output is the input with a description of the function (CutDescription.h), all of its
 * elements and all of its coefficients, at no cost. The representation PixelExact draws what the
 * function leaves. Other filters get the whole mesh.
 */

#ifndef vtkPixelExactCut_h
#define vtkPixelExactCut_h

#include "MeshFilter.h"
#include "PixelExactParaViewFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the function

class vtkImplicitFunction;
class vtkUnstructuredGrid;

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactCut
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  vtkAbstractTypeMacro(vtkPixelExactCut, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the cut function's.
  vtkMTimeType GetMTime() override;

  /**
   * The function that slices or clips, in the data's coordinates.
   */
  void SetCutFunction(vtkImplicitFunction* function);

protected:
  vtkPixelExactCut();
  ~vtkPixelExactCut() override;

  bool Make(vtkDataObject* mesh, Output* output) override;

  /// Adds the description of `function` to the grid. Throws pixelexact::Error.
  virtual void Describe(vtkImplicitFunction* function, vtkUnstructuredGrid* grid) = 0;

private:
  vtkPixelExactCut(const vtkPixelExactCut&) = delete;
  void operator=(const vtkPixelExactCut&) = delete;

  vtkSmartPointer<vtkImplicitFunction> CutFunction;
};

#endif
