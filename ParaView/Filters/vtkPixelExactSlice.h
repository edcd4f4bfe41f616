// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactSlice
 * @brief   a slice as an object of ParaView's pipeline, which the representation PixelExact draws
 *
 * The output is the input with a description of the cut-surface (CutDescription.h) and all of its
 * coefficients, at no cost. Each slice of a source is an object of its own that ParaView shows,
 * colours and hides. A slice of a slice cuts at its own function only; a slice of a clip is
 * clipped.
 */

#ifndef vtkPixelExactSlice_h
#define vtkPixelExactSlice_h

#include "MeshFilter.h"
#include "PixelExactParaViewFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the function

#include <vector> // for offsets

class vtkImplicitFunction;

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactSlice
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  static vtkPixelExactSlice* New();
  vtkTypeMacro(vtkPixelExactSlice, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the cut function's.
  vtkMTimeType GetMTime() override;

  /**
   * The function whose zeros are the slice.
   */
  void SetCutFunction(vtkImplicitFunction* function);

  ///@{
  /**
   * Distances, in world units, by which a plane is moved along its normal: one slice for each. None
   * is the same as 0. An error for other functions, unless it is 0.
   */
  void SetNumberOfOffsets(int number);
  void SetOffset(int index, double offset);
  ///@}

protected:
  vtkPixelExactSlice();
  ~vtkPixelExactSlice() override;

  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkPixelExactSlice(const vtkPixelExactSlice&) = delete;
  void operator=(const vtkPixelExactSlice&) = delete;

  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  std::vector<double> Offsets;
};

#endif
