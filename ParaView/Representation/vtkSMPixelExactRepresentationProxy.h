// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMPixelExactRepresentationProxy
 * @brief   connects a client's vtkPixelExactRepresentation with the processes that draw
 *
 * On a remote server the pointer is the client's and the elements are the server's. The text of a
 * pixel is requested from all of the server's processes at once. Information of the representation
 * about its data (ranges, pixels) comes from the server's object, because the client's has none.
 *
 * While the grid has another representation, the properties of this one are left out of Python
 * states and traces, so that these run without the plugin.
 *
 * RescaleToVisible sets the colour map to the VisibleRange when it is pushed; colour maps belong to
 * the client.
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
  /**
   * Sets the Surface that the input's XML hint `PixelExactSurface` gives. Without a hint, where the
   * client has a window, the plane faces the camera of a new view, which would see the default
   * plane edge-on; scripts keep the default.
   */
  void ChooseFirstSurface();
  void FollowType();

  vtkWeakPointer<vtkPixelExactRepresentation> Shown;
  std::map<vtkSMProperty*, vtkPVXMLElement*> OwnHints; ///< of exposed properties, as in the XML
  bool IsSetUp = false;
};

#endif
