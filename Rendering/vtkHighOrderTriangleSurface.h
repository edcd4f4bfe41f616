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
#include "vtkHighOrderSurface.h"

#include "vtkSmartPointer.h" // for the input

namespace pixelexact
{
class SurfaceInput;
} // namespace pixelexact

class vtkAlgorithmOutput;
class vtkPolyData;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderTriangleSurface : public vtkHighOrderSurface
{
public:
  static vtkHighOrderTriangleSurface* New();
  vtkTypeMacro(vtkHighOrderTriangleSurface, vtkHighOrderSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surface, in the data's coordinates: data, or a pipeline, which Update brings up to date.
   * Required.
   */
  void SetInputData(vtkPolyData* data);
  void SetInputConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetInput();
  ///@}

  void Update() override;

  /**
   * Changes with the input, too.
   */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  bool IsMadeOfMesh() const override
  {
    return false;
  }
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

  vtkSmartPointer<pixelexact::SurfaceInput> Input;
};

#endif
