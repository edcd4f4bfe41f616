// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactClip
 * @brief   a clipped mesh as an object of ParaView's pipeline, which the representation PixelExact
 * draws
 *
 * The output is the input with a description of the clip function (CutDescription.h) and all of its
 * elements and coefficients, at no cost. The representation draws the boundary of the mesh where it
 * is kept, and the clip function's zeros in the mesh, which close it. A clip of a clip keeps what
 * both keep. Other filters get the whole mesh.
 */

#ifndef vtkPixelExactClip_h
#define vtkPixelExactClip_h

#include "MeshFilter.h"
#include "PixelExactParaViewFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the function

class vtkImplicitFunction;

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactClip
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  static vtkPixelExactClip* New();
  vtkTypeMacro(vtkPixelExactClip, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the clip function's.
  vtkMTimeType GetMTime() override;

  /**
   * The function that clips.
   */
  void SetClipFunction(vtkImplicitFunction* function);

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

  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkPixelExactClip(const vtkPixelExactClip&) = delete;
  void operator=(const vtkPixelExactClip&) = delete;

  vtkSmartPointer<vtkImplicitFunction> ClipFunction;
  bool InsideOut = true;
};

#endif
