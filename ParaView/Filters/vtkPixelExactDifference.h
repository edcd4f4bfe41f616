// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactDifference
 * @brief   vtkHighOrderDifference, of the parts that several processes have, too
 *
 * The first process gets the parts of both grids and makes the image; the others' are empty.
 */

#ifndef vtkPixelExactDifference_h
#define vtkPixelExactDifference_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkHighOrderDifference.h"

#include <memory> // for the meshes
#include <string> // for the field

namespace pixelexact
{
struct InputCut;
class WholeMesh;
} // namespace pixelexact

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactDifference : public vtkHighOrderDifference
{
public:
  static vtkPixelExactDifference* New();
  vtkTypeMacro(vtkPixelExactDifference, vtkHighOrderDifference);
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

  /**
   * The entry "Same Name" of ParaView's list is the field of the same name.
   */
  void SetSecondFieldName(std::string name) override;

protected:
  vtkPixelExactDifference();
  ~vtkPixelExactDifference() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPixelExactDifference(const vtkPixelExactDifference&) = delete;
  void operator=(const vtkPixelExactDifference&) = delete;

  std::unique_ptr<pixelexact::InputCut> Cut;
  std::unique_ptr<pixelexact::WholeMesh> First;
  std::unique_ptr<pixelexact::WholeMesh> Second;
};

#endif
