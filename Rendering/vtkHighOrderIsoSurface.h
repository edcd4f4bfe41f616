// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderIsoSurface
 * @brief   iso-surface of a field as a cut-surface
 *
 * Uses the mapper's mesh and one of its fields, which may differ from the displayed field. A value
 * that the field is proven not to take is an error, which names the field's range.
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
   * The field. Empty (the default): the grid's first field.
   */
  virtual void SetFieldName(const char* name);
  vtkGetCharFromStdStringMacro(FieldName);
  ///@}

  ///@{
  /**
   * A component, counted from 0, or MAGNITUDE (the default); for a field with one component this is
   * the signed value.
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
   * Allows an empty surface. Off (the default): a value that no element takes is an error. On: only
   * a value outside the range of the whole mesh is an error. For surfaces with
   * vtkHighOrderJumpWalls, because a field may jump across a value without taking it.
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
