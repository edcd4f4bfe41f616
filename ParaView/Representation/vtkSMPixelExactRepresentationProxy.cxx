// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPixelExactRepresentationProxy.h"

#include "vtkPixelExactRepresentation.h"
#include "vtkSMPixelExactShownCut.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <string_view>

vtkStandardNewMacro(vtkSMPixelExactRepresentationProxy);

namespace
{
/// Hints, or none, with one more: ParaView's smtrace writes no property that is linked to settings.
/// Without names the link links nothing.
vtkPVXMLElement* Untraced(vtkPVXMLElement* hints)
{
  // Kept: widgets look into the hints that they were made with.
  static std::map<vtkSmartPointer<vtkPVXMLElement>, vtkSmartPointer<vtkPVXMLElement>> all;
  vtkSmartPointer<vtkPVXMLElement>& untraced = all[hints];
  if (!untraced)
  {
    untraced = vtkSmartPointer<vtkPVXMLElement>::New();
    untraced->SetName("Hints");
    for (unsigned int i = 0; hints != nullptr && i < hints->GetNumberOfNestedElements(); ++i)
    {
      untraced->AddNestedElement(hints->GetNestedElement(i), 0);
    }
    vtkNew<vtkPVXMLElement> link;
    link->SetName("PropertyLink");
    link->AddAttribute("group", "settings");
    untraced->AddNestedElement(link);
  }
  return untraced;
}
} // namespace

//------------------------------------------------------------------------------
vtkSMPixelExactRepresentationProxy::vtkSMPixelExactRepresentationProxy()
{
  this->AddObserver(
    vtkCommand::UpdatePropertyEvent, this, &vtkSMPixelExactRepresentationProxy::PropertyPushed);
}

//------------------------------------------------------------------------------
vtkSMPixelExactRepresentationProxy::~vtkSMPixelExactRepresentationProxy()
{
  if (this->Shown)
  {
    this->Shown->SetPointerSource({});
  }
}

//------------------------------------------------------------------------------
void vtkSMPixelExactRepresentationProxy::CreateVTKObjects()
{
  this->Superclass::CreateVTKObjects();
  if (!this->IsSetUp && this->ObjectsCreated)
  {
    this->IsSetUp = true; // before the object is asked for, which comes by here again
    vtkSMProxy* const parent = this->GetTrueParentProxy();
    if (vtkSMProperty* const type =
          parent != this ? parent->GetProperty("Representation") : nullptr)
    {
      type->AddObserver(
        vtkCommand::ModifiedEvent, this, &vtkSMPixelExactRepresentationProxy::FollowType);
      this->FollowType();
    }
    this->Shown = vtkPixelExactRepresentation::SafeDownCast(this->GetClientSideObject());
    if (this->Shown)
    {
      this->Shown->SetPointerSource([this](int x, int y) { return this->TextAt(x, y); });
    }
  }
}

//------------------------------------------------------------------------------
void vtkSMPixelExactRepresentationProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  vtkSMProperty* const pointer = this->GetProperty("PointerText");
  if (property != pointer)
  {
    const vtkTypeUInt32 everywhere = this->Location;
    this->Location = everywhere & ~static_cast<vtkTypeUInt32>(vtkPVSession::CLIENT);
    this->Superclass::UpdatePropertyInformationInternal(property);
    this->Location = everywhere;
  }
  if (property == nullptr || property == pointer)
  {
    this->Superclass::UpdatePropertyInformationInternal(pointer);
  }
}

//------------------------------------------------------------------------------
std::string vtkSMPixelExactRepresentationProxy::TextAt(int x, int y)
{
  if (vtkProcessModule::GetProcessModule()->GetSymmetricMPIMode())
  {
    return {}; // every process runs the script, but only one has the pointer
  }
  vtkClientServerStream ask;
  ask << vtkClientServerStream::Invoke << VTKOBJECT(this) << "PickAt" << x << y
      << vtkClientServerStream::End;
  this->ExecuteStream(ask, false, vtkPVSession::RENDER_SERVER);
  const char* text = nullptr;
  return this->GetLastResult(vtkPVSession::RENDER_SERVER_ROOT).GetArgument(0, 0, &text) != 0 &&
      text != nullptr
    ? text
    : "";
}

//------------------------------------------------------------------------------
void vtkSMPixelExactRepresentationProxy::ChooseFirstSurface()
{
  vtkSMProxy* const parent = this->GetTrueParentProxy();
  vtkSMProxy* const input = vtkSMPropertyHelper(parent, "Input", true).GetAsProxy();
  vtkPVXMLElement* const hints = input != nullptr ? input->GetHints() : nullptr;
  vtkPVXMLElement* const hint =
    hints != nullptr ? hints->FindNestedElementByName("PixelExactSurface") : nullptr;
  int surface = 0;
  if (hint != nullptr && hint->GetScalarAttribute("value", &surface) != 0)
  {
    vtkSMPropertyHelper(this, "PixelExactSurface").Set(surface);
    this->UpdateProperty("PixelExactSurface");
    return;
  }
  vtkSMProxy* const plane = vtkSMPropertyHelper(this, "CutFunction").GetAsProxy();
  if (plane != nullptr && plane->GetProperty("Normal") != nullptr &&
    vtkSMPixelExactShownCut::HasWindow(this->GetSessionProxyManager()))
  {
    const double normal[3] = { 0.0, 0.0, 1.0 };
    vtkSMPropertyHelper(plane, "Normal").Set(normal, 3);
    plane->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkSMPixelExactRepresentationProxy::FollowType()
{
  vtkSMProxy* const parent = this->GetTrueParentProxy();
  const char* const type = vtkSMPropertyHelper(parent, "Representation").GetAsString();
  const bool isUsed = type != nullptr && std::string_view(type) == "PixelExact";
  // ParaView chooses the first type before it registers the representation, as states do, which
  // have a surface.
  vtkSMSessionProxyManager* const proxies = this->GetSessionProxyManager();
  if (isUsed && !proxies->GetInLoadXMLState() &&
    proxies->GetProxyName("representations", parent) == nullptr)
  {
    this->ChooseFirstSurface();
  }
  const auto iterator = vtkSmartPointer<vtkSMPropertyIterator>::Take(this->NewPropertyIterator());
  for (iterator->Begin(); !iterator->IsAtEnd(); iterator->Next())
  {
    vtkSMProperty* const property = iterator->GetProperty();
    if (parent->GetProperty(iterator->GetKey()) == property)
    {
      const auto own = this->OwnHints.try_emplace(property, property->GetHints()).first->second;
      property->SetHints(isUsed ? own : Untraced(own));
      property->SetDisableSubTrace(isUsed ? nullptr : "1"); // of the cut function
    }
  }
}

//------------------------------------------------------------------------------
void vtkSMPixelExactRepresentationProxy::PropertyPushed(
  vtkObject* /*caller*/, unsigned long /*event*/, void* name)
{
  if (name != nullptr && std::string_view(static_cast<const char*>(name)) == "RescaleToVisible")
  {
    this->RescaleToVisible();
  }
}

//------------------------------------------------------------------------------
void vtkSMPixelExactRepresentationProxy::RescaleToVisible()
{
  vtkSMViewProxy* const view = vtkSMViewProxy::FindView(this->GetTrueParentProxy());
  double range[2];
  this->UpdatePropertyInformation(this->GetProperty("FieldRange"));
  vtkSMPropertyHelper(this, "FieldRange").Get(range, 2);
  if (view == nullptr || !(range[0] <= range[1]))
  {
    return; // nobody clicked: ParaView pushes all properties before it first draws
  }
  this->UpdatePropertyInformation(this->GetProperty("VisibleRange"));
  vtkSMPropertyHelper(this, "VisibleRange").Get(range, 2);
  vtkSMProxy* const map = vtkSMPropertyHelper(this, "LookupTable").GetAsProxy();
  if (map == nullptr || !(range[0] <= range[1]))
  {
    vtkWarningMacro(<< "no values of a field are seen: the colour map keeps its range");
    return;
  }
  vtkSMTransferFunctionProxy::RescaleTransferFunction(map, range);
  if (vtkSMProxy* const opacity =
        vtkSMPropertyHelper(map, "ScalarOpacityFunction", true).GetAsProxy())
  {
    vtkSMTransferFunctionProxy::RescaleTransferFunction(opacity, range);
  }
  view->StillRender();
}

//------------------------------------------------------------------------------
void vtkSMPixelExactRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
