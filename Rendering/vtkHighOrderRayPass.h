// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderRayPass
 * @brief   draws high-order cut-surfaces as a render pass
 *
 * Draws actors with a vtkHighOrderMapper that are not in the renderer, at its place in a chain of
 * passes. The pixels are those that the actors would draw in the renderer. It belongs next to the
 * opaque pass, before the translucent and volumetric ones:
 *
 *   vtkCameraPass(vtkSequencePass[vtkLightsPass, vtkOpaquePass, vtkHighOrderRayPass,
 *     vtkTranslucentPass, vtkVolumetricPass, vtkOverlayPass])
 *
 * The renderer ignores these actors when it frames its scene: call vtkRenderer::ResetCamera and
 * ResetCameraClippingRange with GetBounds(). Translucent actors are blended over the pixels that
 * were drawn before.
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
   * The actors to draw. The mapper of each must be a vtkHighOrderMapper; another mapper is an
   * error. Invisible actors are omitted.
   */
  void AddActor(vtkActor* actor);
  void RemoveActor(vtkActor* actor);
  void RemoveAllActors();
  int GetNumberOfActors();
  vtkActor* GetActor(int index);
  ///@}

  /**
   * The box of all visible actors, for a camera; uninitialised (vtkMath) if there is none.
   */
  void GetBounds(double bounds[6]);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Includes the times of the actors and their mappers.
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
