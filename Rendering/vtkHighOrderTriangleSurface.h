// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderTriangleSurface
 * @brief   the triangles of a vtkPolyData as a cut-surface
 *
 * The surface consists of triangles, triangle strips and other polygons (which vtkTriangleFilter
 * triangulates); vertices and lines are omitted. Triangles are flat: normals are not interpolated
 * between corners. If they share an edge or a corner with the same coordinates, no ray passes
 * between them. Open surfaces end at their rim, also outside the mesh.
 */

#ifndef vtkHighOrderTriangleSurface_h
#define vtkHighOrderTriangleSurface_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderDataSurface.h"

class vtkPolyData;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderTriangleSurface : public vtkHighOrderDataSurface
{
public:
  static vtkHighOrderTriangleSurface* New();
  vtkTypeMacro(vtkHighOrderTriangleSurface, vtkHighOrderDataSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surface, in the data's coordinates, as data or, with SetInputConnection, as a pipeline.
   * Required.
   */
  void SetInputData(vtkPolyData* data);
  vtkPolyData* GetInput();
  ///@}

#ifndef __VTK_WRAP__
  std::shared_ptr<const pixelexact::Surface> MakeSurface(
    const std::shared_ptr<const pixelexact::HighOrderModel>& model,
    const pixelexact::SurfaceSearch& search) override;
#endif

protected:
  vtkHighOrderTriangleSurface();
  ~vtkHighOrderTriangleSurface() override;

private:
  vtkHighOrderTriangleSurface(const vtkHighOrderTriangleSurface&) = delete;
  void operator=(const vtkHighOrderTriangleSurface&) = delete;
};

#endif
