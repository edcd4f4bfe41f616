// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderRayPass
 * @brief   draws high-order cut-surfaces as a render pass
 *
 * Draws actors with a vtkHighOrderMapper that are not in the renderer, at its place in a chain of
 * passes; the same pixels as those actors would draw in the renderer. It belongs before the
 * translucent and volumetric passes, beside the opaque one:
 *
 *   vtkCameraPass(vtkSequencePass[vtkLightsPass, vtkOpaquePass, vtkHighOrderRayPass,
 *     vtkTranslucentPass, vtkVolumetricPass, vtkOverlayPass])
 *
 * The renderer does not know these actors when it frames its scene: call
 * vtkRenderer::ResetCamera and ResetCameraClippingRange with GetBounds(). Opacity is blended over
 * what is drawn before.
 */

#ifndef vtkHighOrderRayPass_h
#define vtkHighOrderRayPass_h

#include "PixelExactRenderingModule.h"
#include "vtkRenderPass.h"

#include "vtkSmartPointer.h" // for the actors

#include <vector> // for the actors

class vtkActor;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderRayPass : public vtkRenderPass
{
public:
  static vtkHighOrderRayPass* New();
  vtkTypeMacro(vtkHighOrderRayPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What to draw. The actor's mapper must be a vtkHighOrderMapper, which is an error otherwise.
   * Invisible actors are left out.
   */
  void AddActor(vtkActor* actor);
  void RemoveActor(vtkActor* actor);
  void RemoveAllActors();
  int GetNumberOfActors();
  vtkActor* GetActor(int index);
  ///@}

  /**
   * The box of all visible actors, for a camera; uninitialised (vtkMath) when there is none.
   */
  void GetBounds(double bounds[6]);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Changes with the actors and their mappers, too.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkHighOrderRayPass();
  ~vtkHighOrderRayPass() override;

private:
  vtkHighOrderRayPass(const vtkHighOrderRayPass&) = delete;
  void operator=(const vtkHighOrderRayPass&) = delete;

  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

#endif
