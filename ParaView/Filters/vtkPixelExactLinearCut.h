// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactLinearCut
 * @brief   vtkHighOrderLinearCut, which may take the cut of its input
 *
 * Triangles of a slice of the input follow the slice.
 */

#ifndef vtkPixelExactLinearCut_h
#define vtkPixelExactLinearCut_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkHighOrderLinearCut.h"

#include <memory> // for the cut

namespace pixelexact
{
struct InputCut;
} // namespace pixelexact

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactLinearCut : public vtkHighOrderLinearCut
{
public:
  static vtkPixelExactLinearCut* New();
  vtkTypeMacro(vtkPixelExactLinearCut, vtkHighOrderLinearCut);
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
  vtkPixelExactLinearCut();
  ~vtkPixelExactLinearCut() override;

  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkPixelExactLinearCut(const vtkPixelExactLinearCut&) = delete;
  void operator=(const vtkPixelExactLinearCut&) = delete;

  std::unique_ptr<pixelexact::InputCut> Cut;
};

#endif
