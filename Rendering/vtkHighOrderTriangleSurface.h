// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderTriangleSurface
 * @brief   the triangles of a vtkPolyData as a cut-surface
 *
 * Triangles, triangle strips and other polygons (cut into triangles by vtkTriangleFilter); vertices
 * and lines are left out. The triangles are met as they are: no normals are made up between their
 * corners, and where they share an edge or a corner, with the same coordinates, no ray slips
 * through between them. Open surfaces end at their rim, also beside the mesh.
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
   * The surface, in the data's coordinates: data, or with
   * SetInputConnection a pipeline. Required.
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
