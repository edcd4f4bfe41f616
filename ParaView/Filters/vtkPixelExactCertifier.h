// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactCertifier
 * @brief   vtkHighOrderCertifier, for which the field "None" is none
 *
 * That is the entry of ParaView's lists of arrays, and what a script has before its input is
 * updated.
 */

#ifndef vtkPixelExactCertifier_h
#define vtkPixelExactCertifier_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkHighOrderCertifier.h"

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactCertifier : public vtkHighOrderCertifier
{
public:
  static vtkPixelExactCertifier* New();
  vtkTypeMacro(vtkPixelExactCertifier, vtkHighOrderCertifier);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetFieldName(std::string name) override;

protected:
  vtkPixelExactCertifier() = default;
  ~vtkPixelExactCertifier() override = default;

private:
  vtkPixelExactCertifier(const vtkPixelExactCertifier&) = delete;
  void operator=(const vtkPixelExactCertifier&) = delete;
};

#endif
