// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactClip
 * @brief   a clipped mesh as an object of ParaView's pipeline, which the representation PixelExact
 * draws
 *
 * The representation draws the boundary of the mesh where it is kept, and the function's zeros in
 * the mesh, which close it. A clip of a clip keeps what both keep.
 */

#ifndef vtkPixelExactClip_h
#define vtkPixelExactClip_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkPixelExactCut.h"

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactClip : public vtkPixelExactCut
{
public:
  static vtkPixelExactClip* New();
  vtkTypeMacro(vtkPixelExactClip, vtkPixelExactCut);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * As Clip's Invert: on, the default, keeps the points where the function is negative, behind a
   * plane and inside a sphere; off keeps the others.
   */
  vtkSetMacro(InsideOut, bool);
  vtkGetMacro(InsideOut, bool);
  ///@}

protected:
  vtkPixelExactClip();
  ~vtkPixelExactClip() override;

  void Describe(vtkImplicitFunction* function, vtkUnstructuredGrid* grid) override;

private:
  vtkPixelExactClip(const vtkPixelExactClip&) = delete;
  void operator=(const vtkPixelExactClip&) = delete;

  bool InsideOut = true;
};

#endif
