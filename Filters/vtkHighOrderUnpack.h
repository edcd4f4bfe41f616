// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderUnpack
 * @brief   coefficients of vtkHighOrderPack back in FieldData
 *
 * Makes the arrays that vtkHighOrderGrid describes of the cells that there are, element e being
 * cell e. Classes of PixelExact do so by themselves and need no unpacking; it saves memory where
 * packed arrays are padded, and time where many of them read the same grid.
 *
 * The input is a grid or composite data. Grids without packed coefficients are passed on. An error:
 * packed tuples that filters changed, or cells that no longer fit (vtkHighOrderGrid).
 */

#ifndef vtkHighOrderUnpack_h
#define vtkHighOrderUnpack_h

#include "PixelExactFiltersModule.h"
#include "vtkDataObjectAlgorithm.h"

class PIXELEXACTFILTERS_EXPORT vtkHighOrderUnpack : public vtkDataObjectAlgorithm
{
public:
  static vtkHighOrderUnpack* New();
  vtkTypeMacro(vtkHighOrderUnpack, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHighOrderUnpack();
  ~vtkHighOrderUnpack() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHighOrderUnpack(const vtkHighOrderUnpack&) = delete;
  void operator=(const vtkHighOrderUnpack&) = delete;
};

#endif
