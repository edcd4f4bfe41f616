// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMPixelExactShownCut
 * @brief   gives new filters in ParaView's window the cut function that their input shows
 *
 * The function is copied from a visible representation PixelExact of the input, if its Surface is
 * Cut. Scripts keep ParaView's defaults, which do not depend on views.
 */

#ifndef vtkSMPixelExactShownCut_h
#define vtkSMPixelExactShownCut_h

#include "PixelExactParaViewModule.h"
#include "vtkSMProxyInitializationHelper.h"

class vtkSMSessionProxyManager;

class PIXELEXACTPARAVIEW_EXPORT vtkSMPixelExactShownCut : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMPixelExactShownCut* New();
  vtkTypeMacro(vtkSMPixelExactShownCut, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

  /**
   * Whether a view is in the window of the client, whose interactors are Qt's.
   */
  static bool HasWindow(vtkSMSessionProxyManager* proxies);

protected:
  vtkSMPixelExactShownCut() = default;
  ~vtkSMPixelExactShownCut() override = default;

private:
  vtkSMPixelExactShownCut(const vtkSMPixelExactShownCut&) = delete;
  void operator=(const vtkSMPixelExactShownCut&) = delete;
};

#endif
