// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMPixelExactInputCutDomain
 * @brief   a check box that is on by default where the input is a PixelExact Slice or Clip
 *
 * These have the hint PixelExactSurface. The default depends on the pipeline alone, so it is the
 * same for scripts, which set properties before data exist. The default in the XML must be on:
 * ParaView replaces the value 0 of a new proxy's script otherwise.
 */

#ifndef vtkSMPixelExactInputCutDomain_h
#define vtkSMPixelExactInputCutDomain_h

#include "PixelExactParaViewModule.h"
#include "vtkSMBooleanDomain.h"

class PIXELEXACTPARAVIEW_EXPORT vtkSMPixelExactInputCutDomain : public vtkSMBooleanDomain
{
public:
  static vtkSMPixelExactInputCutDomain* New();
  vtkTypeMacro(vtkSMPixelExactInputCutDomain, vtkSMBooleanDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int SetDefaultValues(vtkSMProperty* property, bool useUnchecked) override;

protected:
  vtkSMPixelExactInputCutDomain() = default;
  ~vtkSMPixelExactInputCutDomain() override = default;

private:
  vtkSMPixelExactInputCutDomain(const vtkSMPixelExactInputCutDomain&) = delete;
  void operator=(const vtkSMPixelExactInputCutDomain&) = delete;
};

#endif
