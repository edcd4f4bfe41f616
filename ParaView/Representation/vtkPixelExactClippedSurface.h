// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactClippedSurface
 * @brief   the part of a cut-surface where no clip function is positive
 *
 * Clips a surface or cut functions by any number of implicit functions. The elements and their
 * coefficients stay as they are: only the points that rays meet are kept or left out, each by the
 * sign of the clip functions there. A clip therefore costs one evaluation a hit, and values on the
 * kept part are those without a clip. To close a clipped boundary, draw the clip function as a cut
 * function beside it (vtkHighOrderMapper::AddCutFunction).
 *
 * Contours on a clipped surface are drawn, and their pixels are undecided, because no bound is
 * proven between two pixels. Clip functions are evaluated on several threads; VTK's own functions
 * support that, functions written in Python do not.
 */

#ifndef vtkPixelExactClippedSurface_h
#define vtkPixelExactClippedSurface_h

#include "PixelExactParaViewModule.h"
#include "vtkHighOrderSurface.h"
#include "vtkSmartPointer.h" // for surface and functions

#include <vector> // for functions

class vtkImplicitFunction;

class PIXELEXACTPARAVIEW_EXPORT vtkPixelExactClippedSurface : public vtkHighOrderSurface
{
public:
  static vtkPixelExactClippedSurface* New();
  vtkTypeMacro(vtkPixelExactClippedSurface, vtkHighOrderSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is clipped: a surface, or, where it is null, all cut functions. Cut functions need closed
   * forms if there are several (vtkHighOrderSceneMapper::SetCutFunction). Without both, drawing
   * reports an error.
   */
  void SetSurface(vtkHighOrderSurface* surface);
  vtkHighOrderSurface* GetSurface();
  void AddCutFunction(vtkImplicitFunction* function);
  void RemoveAllCutFunctions();
  ///@}

  ///@{
  /**
   * Keeps the points where `function`, with its transform, is not positive; `inverted`: where it is
   * not negative. Several clip functions keep what all of them keep.
   */
  void AddClipFunction(vtkImplicitFunction* function, bool inverted = false);
  void RemoveAllClipFunctions();
  ///@}

  void Update() override;
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  bool IsMadeOfMesh() const override;
  std::shared_ptr<const pixelexact::Surface> MakeSurface(
    const std::shared_ptr<const pixelexact::HighOrderModel>& model,
    const pixelexact::SurfaceSearch& search) override;
#endif

protected:
  vtkPixelExactClippedSurface();
  ~vtkPixelExactClippedSurface() override;

private:
  vtkPixelExactClippedSurface(const vtkPixelExactClippedSurface&) = delete;
  void operator=(const vtkPixelExactClippedSurface&) = delete;

  struct Clip
  {
    vtkSmartPointer<vtkImplicitFunction> function;
    bool inverted;
  };
  vtkSmartPointer<vtkHighOrderSurface> Surface;
  std::vector<vtkSmartPointer<vtkImplicitFunction>> CutFunctions;
  std::vector<Clip> Clips;
};

#endif
