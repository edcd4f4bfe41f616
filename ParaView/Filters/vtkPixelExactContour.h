// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactContour
 * @brief   vtkHighOrderContour, which may take the cut of its input
 *
 * Contour lines on a slice of the input follow the slice.
 */

#ifndef vtkPixelExactContour_h
#define vtkPixelExactContour_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkHighOrderContour.h"

#include <memory> // for the cut

namespace pixelexact
{
struct InputCut;
} // namespace pixelexact

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactContour : public vtkHighOrderContour
{
public:
  static vtkPixelExactContour* New();
  vtkTypeMacro(vtkPixelExactContour, vtkHighOrderContour);
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
  vtkPixelExactContour();
  ~vtkPixelExactContour() override;

  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkPixelExactContour(const vtkPixelExactContour&) = delete;
  void operator=(const vtkPixelExactContour&) = delete;

  std::unique_ptr<pixelexact::InputCut> Cut;
};

#endif
