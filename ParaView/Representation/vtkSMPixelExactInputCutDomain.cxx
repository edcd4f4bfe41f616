// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPixelExactInputCutDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

vtkStandardNewMacro(vtkSMPixelExactInputCutDomain);

//------------------------------------------------------------------------------
int vtkSMPixelExactInputCutDomain::SetDefaultValues(vtkSMProperty* property, bool useUnchecked)
{
  vtkSMProperty* const input = this->GetRequiredProperty("Input");
  if (input == nullptr)
  {
    return 0;
  }
  vtkSMPropertyHelper source(input);
  source.SetUseUnchecked(useUnchecked);
  vtkSMProxy* const proxy = source.GetNumberOfElements() > 0 ? source.GetAsProxy() : nullptr;
  vtkPVXMLElement* const hints = proxy != nullptr ? proxy->GetHints() : nullptr;
  const bool cuts =
    hints != nullptr && hints->FindNestedElementByName("PixelExactSurface") != nullptr;
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUnchecked);
  helper.Set(cuts ? 1 : 0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSMPixelExactInputCutDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
