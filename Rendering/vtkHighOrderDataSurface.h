// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderDataSurface
 * @brief   superclass of cut-surfaces that data give, whatever the mesh
 */

#ifndef vtkHighOrderDataSurface_h
#define vtkHighOrderDataSurface_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderSurface.h"

#include "vtkSmartPointer.h" // for the input

namespace pixelexact
{
class SurfaceInput;
} // namespace pixelexact

class vtkAlgorithmOutput;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderDataSurface : public vtkHighOrderSurface
{
public:
  vtkTypeMacro(vtkHighOrderDataSurface, vtkHighOrderSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The data as a pipeline, which Update updates.
   */
  void SetInputConnection(vtkAlgorithmOutput* output);

  void Update() override;

  /**
   * Includes the time of the input.
   */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  bool IsMadeOfMesh() const override
  {
    return false;
  }
#endif

protected:
  vtkHighOrderDataSurface();
  ~vtkHighOrderDataSurface() override;

  vtkSmartPointer<pixelexact::SurfaceInput> Input;

private:
  vtkHighOrderDataSurface(const vtkHighOrderDataSurface&) = delete;
  void operator=(const vtkHighOrderDataSurface&) = delete;
};

#endif
