// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSceneMapper
 * @brief   superclass of vtkHighOrderMapper: what it cuts with
 *
 * Cut functions and one surface, which look as the mapper says, and layers, each with a look of its
 * own. All are written in the data's coordinates. The nearest point inside of the mesh is seen; of
 * surfaces that coincide, the first in this order.
 */

#ifndef vtkHighOrderSceneMapper_h
#define vtkHighOrderSceneMapper_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderContourMapper.h"

#include <memory> // for what it cuts with

namespace pixelexact
{
struct MapperScene;
} // namespace pixelexact

class vtkHighOrderLayer;
class vtkHighOrderSurface;
class vtkImplicitFunction;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderSceneMapper : public vtkHighOrderContourMapper
{
public:
  vtkTypeMacro(vtkHighOrderSceneMapper, vtkHighOrderContourMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The cut-surfaces. SetCutFunction replaces all of them by one, and the Surface; null functions
   * are none and leave it. Where the nearest surface lies outside of the mesh, the next one shows.
   * In closed form, with their transforms, are vtkPlane, vtkSphere, vtkCylinder, vtkCone,
   * vtkQuadric, vtkBox, vtkPlanes, vtkImplicitTorus and vtkImplicitBoolean of these. Any other
   * function is searched for along the rays, by samples: see SetSearchSamples.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  void AddCutFunction(vtkImplicitFunction* function);
  void RemoveCutFunction(vtkImplicitFunction* function);
  void RemoveAllCutFunctions();
  int GetNumberOfCutFunctions();
  vtkImplicitFunction* GetCutFunction(int index);
  ///@}

  ///@{
  /**
   * A cut-surface that is no function: vtkHighOrderSurface. It replaces all cut functions; null,
   * the default, leaves them. Those that are added afterwards (AddCutFunction) are drawn with it,
   * and have the lower layer numbers. For several surfaces: AddLayer.
   */
  void SetSurface(vtkHighOrderSurface* surface);
  vtkHighOrderSurface* GetSurface();
  ///@}

  ///@{
  /**
   * At how many points of a ray a function without a closed form is sampled, from 2 to 65536; the
   * default is 128. They lie evenly on the part of the ray in the mesh's box. Between two of
   * different sign a zero is found, up to rounding. Overlooked are pairs of sheets between two
   * samples, as if nothing was there (what lies behind shows), and places where the function
   * touches zero without changing its sign; a jump from one sign to the other is taken for a zero.
   * The thinner a body is against the mesh, the more samples it needs, and frames take longer in
   * proportion to them.
   */
  vtkSetClampMacro(SearchSamples, int, 2, 65536);
  vtkGetMacro(SearchSamples, int);
  ///@}

  ///@{
  /**
   * Surfaces with looks of their own, drawn together with the cut functions and the surface.
   */
  void AddLayer(vtkHighOrderLayer* layer);
  void RemoveLayer(vtkHighOrderLayer* layer);
  void RemoveAllLayers();
  int GetNumberOfLayers();
  vtkHighOrderLayer* GetLayer(int index);
  ///@}

  ///@{
  /**
   * Whether the renderer's lights shine on planes that are cut functions. Off (the default): their
   * colours are shown as they are. Other surfaces are lit where the actor's property says so.
   */
  vtkSetMacro(LightFlat, bool);
  vtkGetMacro(LightFlat, bool);
  vtkBooleanMacro(LightFlat, bool);
  ///@}

  ///@{
  /**
   * Samples in pixels that are not of one colour, for smooth edges, 1 to 1024. The default is 1.
   */
  vtkSetClampMacro(Samples, int, 1, 1024);
  vtkGetMacro(Samples, int);
  ///@}

  ///@{
  /**
   * Whether the lines between elements (the property's EdgeVisibility) are told apart by what lies
   * behind the face: another element's face (black), nothing (blue), faces of other sizes (orange),
   * elements behind a part of it (purple). The default is off: they have the EdgeColor.
   */
  vtkSetMacro(EdgesByKind, bool);
  vtkGetMacro(EdgesByKind, bool);
  vtkBooleanMacro(EdgesByKind, bool);
  ///@}

  ///@{
  /**
   * Whether the pixels in which elements, or surfaces, meet are painted, and their colour. The
   * defaults are off, and black.
   */
  vtkSetMacro(Outlines, bool);
  vtkGetMacro(Outlines, bool);
  vtkBooleanMacro(Outlines, bool);
  vtkSetVector3Macro(OutlineColor, double);
  vtkGetVector3Macro(OutlineColor, double);
  ///@}

  void ShallowCopy(vtkAbstractMapper* mapper) override;

  /**
   * Changes with cut functions, surface and layers, too.
   */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Whether any layer is opaque, and whether any is not: by its opacity or its lookup table. The
   * actor's opacity comes on top.
   */
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  ///@}

protected:
  vtkHighOrderSceneMapper();
  ~vtkHighOrderSceneMapper() override;

#ifndef __VTK_WRAP__
  const pixelexact::MapperScene& GetScene() const
  {
    return *this->Scene;
  }
#endif

  bool LightFlat = false;
  int SearchSamples = 128;
  int Samples = 1;
  bool EdgesByKind = false;
  bool Outlines = false;
  double OutlineColor[3] = { 0.0, 0.0, 0.0 };

private:
  vtkHighOrderSceneMapper(const vtkHighOrderSceneMapper&) = delete;
  void operator=(const vtkHighOrderSceneMapper&) = delete;

  std::unique_ptr<pixelexact::MapperScene> Scene;
};

#endif
