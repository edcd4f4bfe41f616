// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPixelExactShownCut.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <string_view>

vtkStandardNewMacro(vtkSMPixelExactShownCut);

namespace
{
/// The cut function in a visible picture of the source; null where there is none.
vtkSMProxy* ShownCutOf(vtkSMProxy* source, vtkSMSessionProxyManager* proxies)
{
  for (unsigned int i = 0; i < proxies->GetNumberOfProxies("representations"); ++i)
  {
    const char* const name = proxies->GetProxyName("representations", i);
    vtkSMProxy* const shown = proxies->GetProxy("representations", name);
    if (shown != nullptr && shown->GetProperty("PixelExactSurface") != nullptr &&
      vtkSMPropertyHelper(shown, "Input").GetAsProxy() == source &&
      vtkSMPropertyHelper(shown, "Visibility").GetAsInt() != 0 &&
      std::string_view(vtkSMPropertyHelper(shown, "Representation").GetAsString()) ==
        "PixelExact" &&
      vtkSMPropertyHelper(shown, "PixelExactSurface").GetAsInt() == 0)
    {
      return vtkSMPropertyHelper(shown, "CutFunction").GetAsProxy();
    }
  }
  return nullptr;
}
} // namespace

//------------------------------------------------------------------------------
bool vtkSMPixelExactShownCut::HasWindow(vtkSMSessionProxyManager* proxies)
{
  for (unsigned int i = 0; i < proxies->GetNumberOfProxies("views"); ++i)
  {
    const char* const name = proxies->GetProxyName("views", i);
    auto* const view = vtkSMRenderViewProxy::SafeDownCast(proxies->GetProxy("views", name));
    vtkRenderWindowInteractor* const interactor = view != nullptr ? view->GetInteractor() : nullptr;
    if (interactor != nullptr && std::string_view(interactor->GetClassName()).starts_with("QVTK"))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkSMPixelExactShownCut::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* /*xml*/, vtkMTimeType initializationTimeStamp)
{
  vtkSMSessionProxyManager* const proxies = proxy->GetSessionProxyManager();
  vtkSMProperty* const property = proxy->GetProperty("CutFunction");
  if (property == nullptr || property->GetMTime() > initializationTimeStamp || !HasWindow(proxies))
  {
    return;
  }
  vtkSMProxy* const source = vtkSMPropertyHelper(proxy, "Input").GetAsProxy();
  vtkSMProxy* const shown = source != nullptr ? ShownCutOf(source, proxies) : nullptr;
  auto* const choices = property->FindDomain<vtkSMProxyListDomain>();
  vtkSMProxy* const own = shown != nullptr && choices != nullptr
    ? choices->FindProxy(shown->GetXMLGroup(), shown->GetXMLName())
    : nullptr;
  if (own != nullptr)
  {
    own->Copy(shown);
    own->UpdateVTKObjects();
    vtkSMPropertyHelper(property).Set(own);
    proxy->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkSMPixelExactShownCut::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
