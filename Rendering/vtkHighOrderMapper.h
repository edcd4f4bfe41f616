// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderMapper
 * @brief   draws a high-order field on cut-surfaces, every pixel from the exact field
 *
 * Takes a vtkUnstructuredGrid with PixelExact's arrays (vtkHighOrderGrid, or the output of
 * vtkUnstructuredGridToHighOrderGrid), or composite data of such grids, and works with a stock
 * vtkActor. For each pixel, it finds the point where the pixel's ray meets a cut-surface and
 * evaluates the field's own polynomials there. It uses no mesh of triangles and no interpolation.
 * Pixels and depths go into the framebuffer, so that ordinary geometry and the cut hide each other
 * exactly per pixel.
 *
 * - Surfaces: see vtkHighOrderSceneMapper. Functions and surfaces are given in the data's
 *   coordinates; the actor's matrix moves cut and field together.
 * - Field: SetFieldName; else SelectColorArray; else SetInputArrayToProcess(0, ...); else the
 *   grid's first field.
 * - Component of vectors: SetComponent; else that of ColorByArrayComponent; else the lookup table's
 *   VectorMode and VectorComponent, which is the magnitude for tables that the mapper creates
 *   (SetColorMap, or by default).
 * - Colours: the lookup table, by default the colour map viridis, over the range of the field, of
 *   the cut, or a given ScalarRange (see SetRangeMode), or, with UseLookupTableScalarRange, over
 *   the table's own range. With ScalarVisibility off, the actor's colour. Pixels with an undecided
 *   element get the UnknownColor. EdgeVisibility draws lines between elements, of width LineWidth.
 * - Contours of any number of values: see vtkHighOrderContourMapper.
 * - Light: the renderer's lights, with the surface's exact normals and the actor's property; planes
 *   are not lit unless LightFlat is on.
 * - Opacity and visibility are the actor's; clipping planes and the resolution of coincident
 *   topology (polygon offset) are the mapper's. Each other setting of stock mappers has its usual
 *   effect, or gives an error, or gives a warning that it has no effect.
 *   Module/Documentation/windows.md has the whole table. Each error and warning is reported once,
 *   not in each frame.
 *
 * The mapper keeps the field's locator while the grid is unchanged. For each renderer, actor and
 * eye (of stereo windows) it keeps the last frame while view and scene are unchanged. A changed
 * lookup table only recolours it. See GetNumberOfTraces().
 *
 * While the user moves the scene (in a window with an interactor whose DesiredUpdateRate is one
 * frame per second or more) and exact frames take longer, the mapper shows coarse frames: blocks of
 * 16 x 16 or 4 x 4 pixels with the colour of one pixel. Further renders of the same view refine
 * them. When the window has time, the frame is completed, and equals, to the bit, a frame that was
 * traced at once. Pictures that vtkWindowToImageFilter renders are always complete.
 *
 * Layers that are not opaque are drawn with the renderer's translucent geometry, sheet by sheet
 * with their own depths.
 *
 * Picking: VTK's hardware selection (vtkPropPicker, vtkHardwareSelector, vtkRenderedAreaPicker)
 * selects the pixels as those of the actor, each with the number of its source cell.
 * vtkHighOrderPicker reports all data of a pixel. The mapper has no polygons. Other callers that
 * request the mapper's input (vtkCellPicker, vtkPointPicker, exporters) get an empty vtkPolyData
 * and a warning, once between two renders, because the outside of the mesh is not what the picture
 * shows.
 */

#ifndef vtkHighOrderMapper_h
#define vtkHighOrderMapper_h

#include "PixelExactRenderingModule.h"
#include "vtkHighOrderSceneMapper.h"
#include "vtkSmartPointer.h" // for pictures

#include <array>      // for ranges
#include <functional> // for progress
#include <memory>     // for the implementation and appearances
#include <optional>   // for picks
#include <string>     // for the field's name
#include <vector>     // for warnings

namespace pixelexact
{
class Renderer;
struct Appearance;
struct CameraSight;
struct PickRay;
struct PickedSample;
} // namespace pixelexact

class vtkCompositeDataSet;
class vtkDataObject;
class vtkImageData;
class vtkRenderWindow;
class vtkUnstructuredGrid;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderMapper : public vtkHighOrderSceneMapper
{
public:
  static vtkHighOrderMapper* New();
  vtkTypeMacro(vtkHighOrderMapper, vtkHighOrderSceneMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The grid. It may be a plain vtkUnstructuredGrid, as files and filters return it, if it has
   * PixelExact's arrays. It may also be composite data (vtkMultiBlockDataSet,
   * vtkPartitionedDataSet, vtkPartitionedDataSetCollection) with such grids as leaves. Their
   * elements form one scene with the fields that all leaves have, and the coefficients are copied.
   * Then GetInput returns null; otherwise GetCompositeInput does. Through vtkMapper's or
   * vtkAlgorithm's functions (vtkMapper::GetInput, GetInputDataObject) the input is an empty
   * vtkPolyData: see the class's description.
   */
  void SetInputData(vtkDataObject* data);
  vtkUnstructuredGrid* GetInput();
  vtkCompositeDataSet* GetCompositeInput();
  ///@}

  ///@{
  /**
   * The field. Empty (the default): see the class's description.
   */
  virtual void SetFieldName(const char* name);
  vtkGetCharFromStdStringMacro(FieldName);
  ///@}

  ///@{
  /**
   * The component, as in vtkHighOrderLayer: counted from 0; vtkHighOrderLayer::MAGNITUDE (-1); or
   * vtkHighOrderLayer::BY_LOOKUP_TABLE (-2, the default): see the class's description.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  /**
   * Count of the last frame's samples, on all sheets, that lie on searched surfaces, where the
   * search may have missed hits before them; 0 if all surfaces have closed forms. Samples outside
   * the mesh are not counted.
   */
  vtkIdType GetNumberOfNumericHits();

  ///@{
  /**
   * IsFrameComplete: the last frame is exact in every decided pixel, and neither coarse (see
   * SetProgressive) nor aborted. GetNumberOfUnknownPixels: count of its pixels with the
   * UnknownColor. False and 0 if there is no frame.
   */
  bool IsFrameComplete();
  vtkIdType GetNumberOfUnknownPixels();
  ///@}

  ///@{
  /**
   * Counts of the last frame's pixels: those that a contour proven crosses; of these, those where
   * the field jumps across a value; with ContourInterior, those with only a loop inside; and
   * undecided ones. 0 without contours, and for coarse frames.
   */
  vtkIdType GetNumberOfContourPixels();
  vtkIdType GetNumberOfContourJumpPixels();
  vtkIdType GetNumberOfContourLoopPixels();
  vtkIdType GetNumberOfUndecidedContourPixels();
  ///@}

  /**
   * The range of the lookup table.
   */
  enum
  {
    RANGE_AS_SET,   ///< the given ScalarRange
    RANGE_OF_FIELD, ///< proven range, over the whole mesh, of the fields that the table colours
    RANGE_OF_CUT,   ///< range of the values that the drawn view shows
    RANGE_OF_PERCENTILES ///< the RangePercentiles of these values, one value per pixel
  };

  ///@{
  /**
   * The range of the mapper's lookup table, unless UseLookupTableScalarRange is on. The default is
   * RANGE_OF_FIELD, which is proven to contain all values of the field and usually exceeds them by
   * less than a thousandth. The first frame computes it, and it does not change when the camera
   * moves. RANGE_OF_CUT is widened if the values differ only by rounding. SetScalarRange selects
   * RANGE_AS_SET. GetScalarRange returns the range of the last frame.
   */
  void SetRangeMode(int mode);
  vtkGetMacro(RangeMode, int);
  void SetRangeModeToAsSet() { this->SetRangeMode(RANGE_AS_SET); }
  void SetRangeModeToField() { this->SetRangeMode(RANGE_OF_FIELD); }
  void SetRangeModeToCut() { this->SetRangeMode(RANGE_OF_CUT); }
  void SetRangeModeToPercentiles() { this->SetRangeMode(RANGE_OF_PERCENTILES); }
  using vtkMapper::SetScalarRange;
  void SetScalarRange(double lower, double upper) override;
  ///@}

  ///@{
  /**
   * The percentages of RANGE_OF_PERCENTILES, 0 to 100, ascending. Other pairs cause an error when
   * the frame is drawn. The default is 1 and 99.
   */
  vtkSetVector2Macro(RangePercentiles, double);
  vtkGetVector2Macro(RangePercentiles, double);
  ///@}

  ///@{
  /**
   * Extends a computed range (all modes except RANGE_AS_SET) to be symmetric about 0. The default
   * is off.
   */
  vtkSetMacro(RangeSymmetric, bool);
  vtkGetMacro(RangeSymmetric, bool);
  vtkBooleanMacro(RangeSymmetric, bool);
  ///@}

  /**
   * The range of the values that the last frame shows in the colours of the mapper's lookup table,
   * as in RANGE_OF_CUT; 1 and -1 if there are none.
   */
  double* GetSeenRange() VTK_SIZEHINT(2);

  /**
   * Sets a lookup table with one of the colour maps of the command-line program's --colormap, such
   * as viridis, or viridis_r, which is reversed. It maps vectors by their magnitude. Any other name
   * is an error, which lists the names.
   */
  void SetColorMap(const std::string& name);

  ///@{
  /**
   * RGBA of the pixels with an undecided element. The default is magenta.
   */
  vtkSetVector4Macro(UnknownColor, unsigned char);
  vtkGetVector4Macro(UnknownColor, unsigned char);
  ///@}

  ///@{
  /**
   * From 1 to 256: values are shown in this number of single-coloured steps, equally wide over the
   * range of each lookup table (of equal ratios if it is logarithmic). 0, the default: the table's
   * own colours. The table itself, which a scalar bar shows, is not changed.
   */
  vtkSetClampMacro(Bands, int, 0, 256);
  vtkGetMacro(Bands, int);
  ///@}

  ///@{
  /**
   * Shows the UndecidedColor in pixels whose colour the proven enclosure of the value does not
   * decide, or for which it is undecided whether a contour crosses them. The default is off; the
   * default colour is a red. Causes an error together with several Samples, and with layers in
   * single precision.
   */
  vtkSetMacro(ShowUndecided, bool);
  vtkGetMacro(ShowUndecided, bool);
  vtkBooleanMacro(ShowUndecided, bool);
  vtkSetVector3Macro(UndecidedColor, double);
  vtkGetVector3Macro(UndecidedColor, double);
  ///@}

  ///@{
  /**
   * Shows coarse frames while the window needs frames fast. The default is on.
   */
  vtkSetMacro(Progressive, bool);
  vtkGetMacro(Progressive, bool);
  vtkBooleanMacro(Progressive, bool);
  ///@}

  ///@{
  /**
   * Time limit, in seconds, of a frame in a window with an interactor that does not need frames
   * fast. A frame that is not complete in time is shown, and a timer of the interactor renders the
   * window until the frame is complete (IsFrameComplete). Events then wait for at most this time
   * and the time of one tile. With 0, the default, each render completes the frame. Like
   * Progressive, it does not apply to a camera's first frame.
   */
  vtkSetClampMacro(StillSeconds, double, 0.0, 1e9);
  vtkGetMacro(StillSeconds, double);
  ///@}

  /**
   * The last frame as an image of the viewport's size, lower left pixel first, with the point
   * arrays Value, Position, Normal, Xi, Element, Depth, Verdict, Layer, Color and, with contours,
   * Contour (0: no contour crosses the pixel, 1: one does, 2: undecided). Null before the first
   * frame and after a failed one. Positions and depths (along the unit ray) are in the data's
   * coordinates. Elements are the cells of the source; for composite data, of the block with the
   * flat index in a further array, Block.
   *
   * A frame is traced with the buffers that drawing needs. The first call for a frame traces the
   * others, and the pixels that a coarse frame lacks.
   */
  vtkImageData* GetBuffers();

  ///@{
  /**
   * Counts, over the mapper's lifetime, of models constructed from a grid, cut-surfaces
   * constructed, traces, and colourings.
   */
  vtkIdType GetNumberOfModelBuilds();
  vtkIdType GetNumberOfSurfaceBuilds();
  vtkIdType GetNumberOfTraces();
  vtkIdType GetNumberOfColorings();
  ///@}

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  void CreateDefaultLookupTable() override;

  ///@{
  /**
   * A box that contains the field's whole domain, including curved faces.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->vtkMapper::GetBounds(bounds); }
  ///@}

#ifndef __VTK_WRAP__
  /**
   * For programs with an appearance of their own, such as `pixelexact view`: the mapper's layers
   * are drawn with it, independent of the settings of mapper, actor and layers. Lights come from
   * the renderer. Null: the settings apply. Render reports an appearance with another number of
   * layers.
   */
  void SetAppearance(std::shared_ptr<const pixelexact::Appearance> appearance);
#endif

protected:
  vtkHighOrderMapper();
  ~vtkHighOrderMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkExecutive* CreateDefaultExecutive() override;

  std::string FieldName;
  int Component = -2;
  unsigned char UnknownColor[4] = { 255, 0, 255, 255 };
  int Bands = 0;
  bool ShowUndecided = false;
  double UndecidedColor[3] = { 1.0, 0.0, 0.5 };
  bool Progressive = true;
  double StillSeconds = 0.0;
  int RangeMode = RANGE_OF_FIELD;
  double RangePercentiles[2] = { 1.0, 99.0 };
  bool RangeSymmetric = false;

private:
  friend class vtkHighOrderPicker;
  friend class vtkHighOrderPicture;
  friend class vtkHighOrderRayPass;
  vtkHighOrderMapper(const vtkHighOrderMapper&) = delete;
  void operator=(const vtkHighOrderMapper&) = delete;

  /**
   * Draws opaque and translucent layers at once, for callers without phases.
   */
  void RenderAll(vtkRenderer* renderer, vtkActor* actor);
  void RenderPart(int part, vtkRenderer* renderer, vtkActor* actor);
  /**
   * Complaints about a frame: settings without effect, and incomplete results.
   */
  std::vector<std::string> Complaints(const pixelexact::Renderer& frames, vtkActor* actor);
  void Warn(vtkRenderer* renderer, vtkActor* actor);
  /**
   * Takes over the frame's range of colours as ScalarRange.
   */
  void TakeRange(const pixelexact::Renderer& frames);
  /**
   * Takes over the frame's contour values.
   */
  void TakeContours(const pixelexact::Renderer& frames);
  /**
   * Time limit of a frame in this window; infinite: none.
   */
  double SecondsToTrace(vtkRenderWindow* window);

  /**
   * The first visible point on a ray. Throws pixelexact::Error.
   */
  std::optional<pixelexact::PickedSample> PickSample(
    const pixelexact::PickRay& ray, vtkActor* actor);

  /**
   * A picture through a camera, without a renderer; null if it was aborted. Throws
   * pixelexact::Error.
   */
  vtkSmartPointer<vtkImageData> TracePicture(pixelexact::Renderer& frames,
    const pixelexact::CameraSight& sight, bool allBuffers,
    const std::function<bool(double)>& progress);

  /**
   * Positions of the visible pixels, in world space; empty if the scene has an error, which Render
   * reports. Keeps nothing.
   */
  std::vector<std::array<double, 3>> SeenPoints(const pixelexact::CameraSight& sight);

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
