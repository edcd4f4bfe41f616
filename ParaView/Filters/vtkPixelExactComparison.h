// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactComparison
 * @brief   vtkHighOrderComparison, of the parts that several processes have, too
 *
 * The first process gets the parts of the grid and of the surfaces and makes the table; the others'
 * are empty.
 */

#ifndef vtkPixelExactComparison_h
#define vtkPixelExactComparison_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkHighOrderComparison.h"

#include <memory> // for the mesh

namespace pixelexact
{
struct InputCut;
class WholeMesh;
} // namespace pixelexact

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactComparison : public vtkHighOrderComparison
{
public:
  static vtkPixelExactComparison* New();
  vtkTypeMacro(vtkPixelExactComparison, vtkHighOrderComparison);
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
  vtkPixelExactComparison();
  ~vtkPixelExactComparison() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPixelExactComparison(const vtkPixelExactComparison&) = delete;
  void operator=(const vtkPixelExactComparison&) = delete;

  std::unique_ptr<pixelexact::InputCut> Cut;
  std::unique_ptr<pixelexact::WholeMesh> Mesh;
};

#endif
