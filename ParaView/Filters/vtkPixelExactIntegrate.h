// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactIntegrate
 * @brief   vtkHighOrderIntegrate, which may take the cut of its input
 *
 * Integrals over slices of the input are clipped by its clips. Without slices the surface is the
 * cut that closes the clips. The clips also clip the boundary and iso-surfaces.
 */

#ifndef vtkPixelExactIntegrate_h
#define vtkPixelExactIntegrate_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkHighOrderIntegrate.h"

#include <memory> // for the cut
#include <vector> // for patches

namespace pixelexact
{
struct InputCut;
} // namespace pixelexact

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactIntegrate : public vtkHighOrderIntegrate
{
public:
  static vtkPixelExactIntegrate* New();
  vtkTypeMacro(vtkPixelExactIntegrate, vtkHighOrderIntegrate);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the cut function's.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The cut function, and whether that of the input replaces it; see pixelexact::InputCut.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  void SetUseInputCut(bool use);
  ///@}

protected:
  vtkPixelExactIntegrate();
  ~vtkPixelExactIntegrate() override;

  bool Make(vtkDataObject* mesh, Output* output) override;
  std::vector<pixelexact::SurfacePatch> PatchesFor(vtkDataObject* mesh) override;
  std::vector<pixelexact::ImplicitPolynomial> ClipsFor(vtkDataObject* mesh) override;

private:
  vtkPixelExactIntegrate(const vtkPixelExactIntegrate&) = delete;
  void operator=(const vtkPixelExactIntegrate&) = delete;

  std::unique_ptr<pixelexact::InputCut> Cut;
};

#endif
