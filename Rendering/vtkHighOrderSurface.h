// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSurface
 * @brief   a cut-surface that is no implicit function
 *
 * What vtkHighOrderMapper::SetSurface and vtkHighOrderLayer::SetSurface take beside
 * vtkImplicitFunction: surfaces of triangles or patches, and those that are made of the mesh
 * itself. Coordinates are the data's, as with functions.
 *
 * A mapper makes what rays meet once, for all of its views, and anew when GetMTime has changed or,
 * of a surface that is made of the mesh, when the data have: other cameras, colours and opacities
 * make nothing (vtkHighOrderMapper::GetNumberOfSurfaceBuilds).
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
   * Brings the pipeline of a surface that has an input up to date. Mappers that are not Static call
   * it before each picture.
   */
  virtual void Update();

#ifndef __VTK_WRAP__
  /**
   * Whether it is another surface where the mesh or its fields are others.
   */
  virtual bool IsMadeOfMesh() const
  {
    return true;
  }

  /**
   * What rays meet, for the mesh and fields of a model, and where and how to search for what has no
   * closed form. It may outlive this object, and is not changed by what is set later. Throws
   * pixelexact::Error, which names the remedy.
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
