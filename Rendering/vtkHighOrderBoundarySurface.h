// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderBoundarySurface
 * @brief   faces of elements as a cut-surface
 *
 * The faces belong to the mapper's mesh: its boundary (the default), parts of the boundary by their
 * attributes, all faces of some elements, or the faces between elements. Selections are combined.
 */

#ifndef vtkHighOrderBoundarySurface_h
#define vtkHighOrderBoundarySurface_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderSurface.h"

#include <memory> // for the implementation

namespace pixelexact
{
struct BoundaryChoice;
} // namespace pixelexact

class PIXELEXACTRENDERING_EXPORT vtkHighOrderBoundarySurface : public vtkHighOrderSurface
{
public:
  static vtkHighOrderBoundarySurface* New();
  vtkTypeMacro(vtkHighOrderBoundarySurface, vtkHighOrderSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Selects the whole boundary of the mesh and discards other selections. This is the default.
   */
  void SelectAll();

  ///@{
  /**
   * Selects the faces of the boundary that have an attribute, as numbered by the solver.
   */
  void AddAttribute(int attribute);
  int GetNumberOfAttributes();
  int GetAttribute(int index);
  ///@}

  ///@{
  /**
   * Selects all faces of an element, including inner ones. Its number is that of its cell in the
   * source, as in vtkHighOrderMapper::GetBuffers; for composite data, that of a cell of every
   * block.
   */
  void AddElement(vtkIdType element);
  int GetNumberOfElements();
  vtkIdType GetElement(int index);
  ///@}

  ///@{
  /**
   * Whether the faces between elements are selected, with the values of the element with the lower
   * number; false by default. Hanging faces are drawn from both sides, faces that others cover in
   * part are left out.
   */
  void SetInnerFaces(bool inner);
  bool GetInnerFaces();
  void InnerFacesOn() { this->SetInnerFaces(true); }
  void InnerFacesOff() { this->SetInnerFaces(false); }
  ///@}

#ifndef __VTK_WRAP__
  std::shared_ptr<const pixelexact::Surface> MakeSurface(
    const std::shared_ptr<const pixelexact::HighOrderModel>& model,
    const pixelexact::SurfaceSearch& search) override;
#endif

protected:
  vtkHighOrderBoundarySurface();
  ~vtkHighOrderBoundarySurface() override;

private:
  vtkHighOrderBoundarySurface(const vtkHighOrderBoundarySurface&) = delete;
  void operator=(const vtkHighOrderBoundarySurface&) = delete;

  std::unique_ptr<pixelexact::BoundaryChoice> Choice;
};

#endif
