// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactSlice
 * @brief   a slice as an object of ParaView's pipeline, which the representation PixelExact draws
 *
 * Each slice of a source is an object of its own that ParaView shows, colours and hides. A slice of
 * a slice cuts at its own function only; a slice of a clip is clipped.
 */

#ifndef vtkPixelExactSlice_h
#define vtkPixelExactSlice_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkPixelExactCut.h"

#include <vector> // for offsets

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactSlice : public vtkPixelExactCut
{
public:
  static vtkPixelExactSlice* New();
  vtkTypeMacro(vtkPixelExactSlice, vtkPixelExactCut);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  void Describe(vtkImplicitFunction* function, vtkUnstructuredGrid* grid) override;

private:
  vtkPixelExactSlice(const vtkPixelExactSlice&) = delete;
  void operator=(const vtkPixelExactSlice&) = delete;

  std::vector<double> Offsets;
};

#endif
