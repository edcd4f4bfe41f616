// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderJumpWalls
 * @brief   walls where a field jumps across a value between two elements, as a cut-surface
 *
 * The parts of faces between elements where the field jumps across the value: the values on the two
 * sides are proven to lie on different sides of it. Together with a vtkHighOrderIsoSurface of the
 * same field, component and value they form the boundary between smaller and larger values. A
 * continuous field has no walls, and nothing is drawn. Values on a wall are those of one of the two
 * elements.
 *
 * Use it in a vtkHighOrderLayer of its own, with a colour that distinguishes walls from the
 * surface.
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
