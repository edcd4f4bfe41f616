// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderPatchSurface
 * @brief   Bezier patches as a cut-surface
 *
 * The surface consists of tensor-product patches with given control points, which rays meet
 * exactly, without triangles. The input is
 * - a vtkUnstructuredGrid whose cells are all VTK_BEZIER_QUADRILATERAL, of any degree, also of
 *   different degrees in the two directions (cell array HigherOrderDegrees); or
 * - points without cells, or only with vertices: each 16 points are a bicubic patch, row by row
 *   (the second parameter runs fastest), as in the files of the tool's --patch.
 *
 * Rational weights that differ inside a cell are refused, because such patches are not polynomials.
 */

#ifndef vtkHighOrderPatchSurface_h
#define vtkHighOrderPatchSurface_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderDataSurface.h"

class vtkPointSet;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderPatchSurface : public vtkHighOrderDataSurface
{
public:
  static vtkHighOrderPatchSurface* New();
  vtkTypeMacro(vtkHighOrderPatchSurface, vtkHighOrderDataSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The patches, in the data's coordinates, as data or, with SetInputConnection, as a pipeline.
   * Required.
   */
  void SetInputData(vtkPointSet* data);
  vtkPointSet* GetInput();
  ///@}

#ifndef __VTK_WRAP__
  std::shared_ptr<const pixelexact::Surface> MakeSurface(
    const std::shared_ptr<const pixelexact::HighOrderModel>& model,
    const pixelexact::SurfaceSearch& search) override;
#endif

protected:
  vtkHighOrderPatchSurface();
  ~vtkHighOrderPatchSurface() override;

private:
  vtkHighOrderPatchSurface(const vtkHighOrderPatchSurface&) = delete;
  void operator=(const vtkHighOrderPatchSurface&) = delete;
};

#endif
