// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMPixelExactRepresentationProxy
 * @brief   a client's vtkPixelExactRepresentation knows the processes that draw
 *
 * Where a server draws, the pointer is the client's and the elements are the server's: the text of
 * a pixel is asked of all of the server's processes at once, and what the representation tells of
 * its data (ranges, pixels) is that of the server's object, not of the client's, which has none.
 *
 * While the grid is drawn another way, its own properties are left out of Python states and traces,
 * so that these run where the plugin is not loaded.
 *
 * RescaleToVisible, once it is pushed, gives the colour map the VisibleRange: colour maps are the
 * client's.
 */

#ifndef vtkSMPixelExactRepresentationProxy_h
#define vtkSMPixelExactRepresentationProxy_h

#include "PixelExactParaViewModule.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkWeakPointer.h" // for the client's object

#include <map>    // for hints
#include <string> // for texts

class vtkPVXMLElement;
class vtkPixelExactRepresentation;
class vtkSMProperty;

class PIXELEXACTPARAVIEW_EXPORT vtkSMPixelExactRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMPixelExactRepresentationProxy* New();
  vtkTypeMacro(vtkSMPixelExactRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMPixelExactRepresentationProxy();
  ~vtkSMPixelExactRepresentationProxy() override;

  void CreateVTKObjects() override;
  void UpdatePropertyInformationInternal(vtkSMProperty* property = nullptr) override;

private:
  vtkSMPixelExactRepresentationProxy(const vtkSMPixelExactRepresentationProxy&) = delete;
  void operator=(const vtkSMPixelExactRepresentationProxy&) = delete;

  std::string TextAt(int x, int y);
  void PropertyPushed(vtkObject* caller, unsigned long event, void* name);
  void RescaleToVisible();
  void FollowType();

  vtkWeakPointer<vtkPixelExactRepresentation> Shown;
  std::map<vtkSMProperty*, vtkPVXMLElement*> OwnHints; ///< of exposed properties, as in the XML
  bool IsSetUp = false;
};

#endif
