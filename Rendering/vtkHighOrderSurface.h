// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSurface
 * @brief   a cut-surface that is no implicit function
 *
 * The argument of vtkHighOrderMapper::SetSurface and vtkHighOrderLayer::SetSurface: surfaces of
 * triangles or patches, and surfaces of the mesh itself. Coordinates are the data's, as for
 * functions.
 *
 * A mapper constructs the traced surface once for all of its views. It reconstructs the surface
 * after a change of GetMTime or, for a surface of the mesh, of the data, but not for other cameras,
 * colours and opacities (vtkHighOrderMapper::GetNumberOfSurfaceBuilds).
 */

#ifndef vtkHighOrderSurface_h
#define vtkHighOrderSurface_h

#include "PixelExactRenderingModule.h"
#include "vtkObject.h"

#include <memory> // for what rays meet

namespace pixelexact
{
class HighOrderModel;
class Surface;
struct SurfaceSearch;
} // namespace pixelexact

class PIXELEXACTRENDERING_EXPORT vtkHighOrderSurface : public vtkObject
{
public:
  vtkTypeMacro(vtkHighOrderSurface, vtkObject);

  /**
   * Updates the pipeline of a surface with an input. Mappers that are not Static call it before
   * each picture.
   */
  virtual void Update();

#ifndef __VTK_WRAP__
  /**
   * The surface depends on the mesh or its fields.
   */
  virtual bool IsMadeOfMesh() const
  {
    return true;
  }

  /**
   * Constructs the traced surface for the mesh and fields of a model. `search`: box and samples for
   * surfaces without a closed form. The result may outlive this object, and later settings do not
   * change it. Throws pixelexact::Error, which names the remedy.
   */
  virtual std::shared_ptr<const pixelexact::Surface> MakeSurface(
    const std::shared_ptr<const pixelexact::HighOrderModel>& model,
    const pixelexact::SurfaceSearch& search) = 0;
#endif

protected:
  vtkHighOrderSurface();
  ~vtkHighOrderSurface() override;

private:
  vtkHighOrderSurface(const vtkHighOrderSurface&) = delete;
  void operator=(const vtkHighOrderSurface&) = delete;
};

#endif
