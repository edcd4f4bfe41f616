// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderJumpWalls
 * @brief   where a field jumps across a value between two elements, as a cut-surface
 *
 * The parts of faces between elements that a vtkHighOrderIsoSurface of the same field, component
 * and value lacks to be the boundary between less and more: there the values on the two sides are
 * proven to lie on different sides of the value. Of a field that is continuous there are none, and
 * nothing is drawn. Values on a wall are those of one of the two elements.
 *
 * Meant for a vtkHighOrderLayer of its own, in a colour that tells walls from the surface.
 */

#ifndef vtkHighOrderJumpWalls_h
#define vtkHighOrderJumpWalls_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderIsoSurface.h"

class PIXELEXACTRENDERING_EXPORT vtkHighOrderJumpWalls : public vtkHighOrderIsoSurface
{
public:
  static vtkHighOrderJumpWalls* New();
  vtkTypeMacro(vtkHighOrderJumpWalls, vtkHighOrderIsoSurface);

#ifndef __VTK_WRAP__
  std::shared_ptr<const pixelexact::Surface> MakeSurface(
    const std::shared_ptr<const pixelexact::HighOrderModel>& model,
    const pixelexact::SurfaceSearch& search) override;
#endif

protected:
  vtkHighOrderJumpWalls();
  ~vtkHighOrderJumpWalls() override;

private:
  vtkHighOrderJumpWalls(const vtkHighOrderJumpWalls&) = delete;
  void operator=(const vtkHighOrderJumpWalls&) = delete;
};

#endif
