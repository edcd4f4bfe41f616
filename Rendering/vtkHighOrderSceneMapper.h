// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSceneMapper
 * @brief   superclass of vtkHighOrderMapper: the cut-surfaces
 *
 * A scene has cut functions and one surface, which have the mapper's appearance, and layers, each
 * with an appearance of its own. All are given in the data's coordinates. The nearest point inside
 * the mesh is visible; of coincident surfaces, the first in this order.
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
   * The cut-surfaces. SetCutFunction replaces all of them, and the Surface, by one; a null function
   * removes all cut functions but not the Surface. If the nearest surface lies outside the mesh,
   * the next one shows. These have closed forms, including their transforms: vtkPlane, vtkSphere,
   * vtkCylinder, vtkCone, vtkQuadric, vtkBox, vtkPlanes, vtkImplicitTorus and vtkImplicitBoolean of
   * these. Surfaces of other functions are searched along the rays, by samples: see
   * SetSearchSamples.
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
   * A cut-surface that is a vtkHighOrderSurface. It replaces all cut functions; null, the default,
   * does not. Functions that are added afterwards (AddCutFunction) are drawn with it, and have the
   * lower layer numbers. For several surfaces, use AddLayer.
   */
  void SetSurface(vtkHighOrderSurface* surface);
  vtkHighOrderSurface* GetSurface();
  ///@}

  ///@{
  /**
   * Number of points of a ray at which a function without a closed form is sampled, from 2 to
   * 65536. The default is 128. The points are evenly spaced on the ray's part in the mesh's box.
   * Between two values of different sign a zero is found, up to rounding. The search misses pairs
   * of sheets between two samples (surfaces behind them show instead), and places where the
   * function touches zero without changing its sign. A jump from one sign to the other counts as a
   * zero. The thinner a body is relative to the mesh, the more samples it needs; time is
   * proportional to samples.
   */
  vtkSetClampMacro(SearchSamples, int, 2, 65536);
  vtkGetMacro(SearchSamples, int);
  ///@}

  ///@{
  /**
   * Surfaces with appearances of their own, drawn together with the cut functions and the surface.
   */
  void AddLayer(vtkHighOrderLayer* layer);
  void RemoveLayer(vtkHighOrderLayer* layer);
  void RemoveAllLayers();
  int GetNumberOfLayers();
  vtkHighOrderLayer* GetLayer(int index);
  ///@}

  ///@{
  /**
   * The renderer's lights illuminate planes that are cut functions. Off (the default): planes show
   * unlit colours. Other surfaces are lit if the actor's property has Lighting on.
   */
  vtkSetMacro(LightFlat, bool);
  vtkGetMacro(LightFlat, bool);
  vtkBooleanMacro(LightFlat, bool);
  ///@}

  ///@{
  /**
   * Samples per pixel that has several colours, for smooth edges, 1 to 1024. The default is 1.
   */
  vtkSetClampMacro(Samples, int, 1, 1024);
  vtkGetMacro(Samples, int);
  ///@}

  ///@{
  /**
   * Colours the lines between elements (the property's EdgeVisibility) by the kind of the face:
   * another element's face behind it (black), nothing (blue), faces of other sizes (orange),
   * elements behind a part of it (purple). The default is off: all lines have the EdgeColor.
   */
  vtkSetMacro(EdgesByKind, bool);
  vtkGetMacro(EdgesByKind, bool);
  vtkBooleanMacro(EdgesByKind, bool);
  ///@}

  ///@{
  /**
   * Paints the pixels in which elements or surfaces meet, in this colour. The defaults are off, and
   * black.
   */
  vtkSetMacro(Outlines, bool);
  vtkGetMacro(Outlines, bool);
  vtkBooleanMacro(Outlines, bool);
  vtkSetVector3Macro(OutlineColor, double);
  vtkGetVector3Macro(OutlineColor, double);
  ///@}

  void ShallowCopy(vtkAbstractMapper* mapper) override;

  /**
   * Includes the times of cut functions, surface and layers.
   */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Some layer is opaque, and some layer is not, by opacity and lookup table. The actor's opacity
   * is not included.
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
