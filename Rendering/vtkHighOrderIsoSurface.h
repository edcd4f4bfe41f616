// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderIsoSurface
 * @brief   where a field has a value, as a cut-surface
 *
 * Of the mapper's mesh and one of its fields, which need not be the field that is shown. A value
 * that the field is proven to have nowhere is an error, which names the field's range.
 */

#ifndef vtkHighOrderIsoSurface_h
#define vtkHighOrderIsoSurface_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderSurface.h"

#include <string> // for the field's name

class PIXELEXACTRENDERING_EXPORT vtkHighOrderIsoSurface : public vtkHighOrderSurface
{
public:
  static vtkHighOrderIsoSurface* New();
  vtkTypeMacro(vtkHighOrderIsoSurface, vtkHighOrderSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * See SetComponent.
   */
  enum
  {
    MAGNITUDE = -1
  };

  ///@{
  /**
   * The field. Empty (the default): the first one that the grid carries.
   */
  virtual void SetFieldName(const char* name);
  vtkGetCharFromStdStringMacro(FieldName);
  ///@}

  ///@{
  /**
   * A component, counted from 0, or MAGNITUDE (the default), which is the value itself of a field
   * that has one component.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * The value. The default is 0.
   */
  vtkSetMacro(Value, double);
  vtkGetMacro(Value, double);
  ///@}

  ///@{
  /**
   * Whether the surface may be nowhere. Off (the default): a value that no element has is an error.
   * On: only one beyond the values of the whole mesh. For surfaces with vtkHighOrderJumpWalls, as a
   * field may have a value nowhere and jump across it.
   */
  vtkSetMacro(MayBeEmpty, bool);
  vtkGetMacro(MayBeEmpty, bool);
  vtkBooleanMacro(MayBeEmpty, bool);
  ///@}

#ifndef __VTK_WRAP__
  std::shared_ptr<const pixelexact::Surface> MakeSurface(
    const std::shared_ptr<const pixelexact::HighOrderModel>& model,
    const pixelexact::SurfaceSearch& search) override;
#endif

protected:
  vtkHighOrderIsoSurface();
  ~vtkHighOrderIsoSurface() override;

  std::string FieldName;
  int Component = MAGNITUDE;
  double Value = 0.0;
  bool MayBeEmpty = false;

private:
  vtkHighOrderIsoSurface(const vtkHighOrderIsoSurface&) = delete;
  void operator=(const vtkHighOrderIsoSurface&) = delete;
};

#endif
