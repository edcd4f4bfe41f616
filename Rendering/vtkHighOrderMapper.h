// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderMapper
 * @brief   draws a high-order field on cut-surfaces, every pixel from the exact field
 *
 * Takes a vtkUnstructuredGrid that carries PixelExact's arrays (vtkHighOrderGrid, or what
 * vtkUnstructuredGridToHighOrderGrid made), or composite data of such, and works with a stock
 * vtkActor: for each pixel the point where its ray meets a cut-surface is found, and the field's
 * own polynomials are evaluated there. There is no mesh of triangles and no interpolation. Pixels
 * and depths go into the framebuffer, so that ordinary geometry hides the cut and is hidden by it,
 * to the pixel.
 *
 * - What is cut: vtkHighOrderSceneMapper. Functions and surfaces are written in the data's
 *   coordinates; the actor's matrix moves cut and field together.
 * - Which field: SetFieldName; else SelectColorArray; else SetInputArrayToProcess(0, ...); else the
 *   first field that the grid carries.
 * - Which component of vectors: SetComponent; else that of ColorByArrayComponent; else the lookup
 *   table's VectorMode and VectorComponent, which is the magnitude for the tables that the mapper
 *   makes (SetColorMap, or where none was set).
 * - Colours: the lookup table, over the range of the field, of the cut, or a ScalarRange that was
 * set (see SetRangeMode), or, with UseLookupTableScalarRange, over the table's own range. With
 *   ScalarVisibility off, the actor's colour. A pixel whose element could not be decided gets the
 *   UnknownColor. EdgeVisibility draws lines between elements, LineWidth wide.
 * - Contours of any number of values: vtkHighOrderContourMapper.
 * - Light: the renderer's, by the surface's exact normals and the actor's property; planes show
 *   their colours as they are unless LightFlat is on.
 * - Opacity and visibility are the actor's, clipping planes and the resolution of coincident
 *   topology (polygon offset) the mapper's. What else stock mappers honour is honoured, or refused
 *   by an error, or said to have no effect by a warning; the whole table is in
 *   Module/Documentation/windows.md. Errors and warnings are told once, not in each frame.
 *
 * What is kept: the field's locator while the grid is unchanged, and for each renderer, actor and
 * eye (of stereo windows) the last frame while view and scene are; a changed lookup table only
 * recolours it. See GetNumberOfTraces().
 *
 * While somebody moves the scene (a window with an interactor that wants a frame each second or
 * more often, its DesiredUpdateRate) and exact frames take longer, coarse ones are shown: blocks of
 * 16 or 4 pixels in both directions with the colour of one. Further renders of the same view refine
 * them; when the window can wait, the frame is completed, and is the same, to the bit, as one that
 * was made at once. Pictures that vtkWindowToImageFilter renders are complete, too.
 *
 * Layers that are not opaque are drawn with the renderer's translucent geometry, sheet by sheet
 * with their own depths.
 *
 * Picking: VTK's hardware selection (vtkPropPicker, vtkHardwareSelector, vtkRenderedAreaPicker)
 * sees the pixels as those of the actor, each with the number of its source cell;
 * vtkHighOrderPicker says all that is known of a pixel. There are no polygons: others who ask for
 * the mapper's input (vtkCellPicker, vtkPointPicker, exporters) get an empty vtkPolyData and a
 * warning, once between two renders, since the outside of the mesh is not what is seen.
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
   * The grid. It may be a plain vtkUnstructuredGrid, as files and filters give them back; what
   * counts are its arrays. Or composite data (vtkMultiBlockDataSet, vtkPartitionedDataSet,
   * vtkPartitionedDataSetCollection) whose leaves are such grids: their elements are one scene, of
   * the fields that all of them have, and the coefficients are copied. GetInput is null then, else
   * GetCompositeInput. Through vtkMapper's or vtkAlgorithm's functions (vtkMapper::GetInput,
   * GetInputDataObject) the input is an empty vtkPolyData: see the class's description.
   */
  void SetInputData(vtkDataObject* data);
  vtkUnstructuredGrid* GetInput();
  vtkCompositeDataSet* GetCompositeInput();
  ///@}

  ///@{
  /**
   * The field to show. Empty (the default): see the class's description.
   */
  virtual void SetFieldName(const char* name);
  vtkGetCharFromStdStringMacro(FieldName);
  ///@}

  ///@{
  /**
   * As of vtkHighOrderLayer: a component, counted from 0; vtkHighOrderLayer::MAGNITUDE (-1); or
   * vtkHighOrderLayer::BY_LOOKUP_TABLE (-2, the default): see the class's description.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  /**
   * How many samples of the last frame, sheets behind others included, lie on surfaces that were
   * searched for, so that something may have been overlooked before them; 0 where all have closed
   * forms. Samples outside of the mesh do not count.
   */
  vtkIdType GetNumberOfNumericHits();

  ///@{
  /**
   * Of the last frame: whether it is exact in every pixel that is decided, and not one of the
   * coarse ones that are shown while the window is in a hurry (see SetProgressive), nor aborted;
   * and how many of its pixels have the UnknownColor. False and 0 where there is none.
   */
  bool IsFrameComplete();
  vtkIdType GetNumberOfUnknownPixels();
  ///@}

  ///@{
  /**
   * Of the last frame's pixels: through how many a contour goes, for sure; because the field jumps
   * across a value there; with ContourInterior, because of a loop inside alone; and of how many
   * that could not be decided. 0 where there are no contours, and of coarse frames.
   */
  vtkIdType GetNumberOfContourPixels();
  vtkIdType GetNumberOfContourJumpPixels();
  vtkIdType GetNumberOfContourLoopPixels();
  vtkIdType GetNumberOfUndecidedContourPixels();
  ///@}

  /**
   * Which range the lookup table gets.
   */
  enum
  {
    RANGE_AS_SET,        ///< ScalarRange
    RANGE_OF_FIELD,      ///< of the fields that it colours, over all of the mesh, proven
    RANGE_OF_CUT,        ///< of the values that are seen in the view that is drawn
    RANGE_OF_PERCENTILES ///< the RangePercentiles of these values, a pixel a value
  };

  ///@{
  /**
   * The range of the mapper's lookup table, unless UseLookupTableScalarRange is on. The default is
   * RANGE_OF_FIELD: it is proven to hold all values of the field, and mostly exceeds them by less
   * than a thousandth; it is found by the first frame, and stays when the scene is turned.
   * RANGE_OF_CUT is wider where rounding alone tells the values apart. To set a ScalarRange is to
   * choose RANGE_AS_SET. GetScalarRange gives the range of the last frame.
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
   * The percentages of RANGE_OF_PERCENTILES, 0 to 100, ascending; another pair is an error when it
   * is drawn. The default is 1 and 99.
   */
  vtkSetVector2Macro(RangePercentiles, double);
  vtkGetVector2Macro(RangePercentiles, double);
  ///@}

  ///@{
  /**
   * Whether a range that is found (all modes but RANGE_AS_SET) is made as wide to both sides of 0.
   * The default is off.
   */
  vtkSetMacro(RangeSymmetric, bool);
  vtkGetMacro(RangeSymmetric, bool);
  vtkBooleanMacro(RangeSymmetric, bool);
  ///@}

  /**
   * The ends of the values that the last frame shows in the colours of the mapper's lookup table,
   * as RANGE_OF_CUT has them; 1 and -1 where there are none.
   */
  double* GetSeenRange() VTK_SIZEHINT(2);

  /**
   * Gives the mapper a lookup table of one of the maps that the command-line program has: viridis,
   * inferno, plasma, coolwarm, jet, rainbow, grayscale. It shows vectors by their magnitude. An
   * error, which lists them, for another name.
   */
  void SetColorMap(const std::string& name);

  ///@{
  /**
   * RGBA of the pixels whose element could not be decided. The default is magenta.
   */
  vtkSetVector4Macro(UnknownColor, unsigned char);
  vtkGetVector4Macro(UnknownColor, unsigned char);
  ///@}

  ///@{
  /**
   * From 1 to 256: values are shown in so many steps of one colour, equally wide over the range of
   * each lookup table (equal ratios where it is logarithmic). 0, the default: the table's own
   * colours. The table itself, which a scalar bar shows, stays as it is.
   */
  vtkSetClampMacro(Bands, int, 0, 256);
  vtkGetMacro(Bands, int);
  ///@}

  ///@{
  /**
   * Whether pixels have the UndecidedColor where the proven enclosure of the value does not decide
   * the colour, or where it is undecided whether a contour crosses them. The default is off; the
   * colour's default is a red. An error with several Samples, and with layers in single precision.
   */
  vtkSetMacro(ShowUndecided, bool);
  vtkGetMacro(ShowUndecided, bool);
  vtkBooleanMacro(ShowUndecided, bool);
  vtkSetVector3Macro(UndecidedColor, double);
  vtkGetVector3Macro(UndecidedColor, double);
  ///@}

  ///@{
  /**
   * Whether coarse frames are shown while the window is in a hurry. The default is on.
   */
  vtkSetMacro(Progressive, bool);
  vtkGetMacro(Progressive, bool);
  vtkBooleanMacro(Progressive, bool);
  ///@}

  ///@{
  /**
   * Where a window has an interactor and is not in a hurry: seconds, after which a frame that is
   * not complete is shown as it is, and the window is rendered again by a timer of the interactor,
   * until it is complete (IsFrameComplete). So events wait no longer than that, and for a tile.
   * With 0, the default, each render ends with the complete frame. As Progressive, this is not for
   * a camera's first frame.
   */
  vtkSetClampMacro(StillSeconds, double, 0.0, 1e9);
  vtkGetMacro(StillSeconds, double);
  ///@}

  /**
   * The last frame as an image of the viewport's size, lower left pixel first, with the point
   * arrays Value, Position, Normal, Xi, Element, Depth, Verdict, Layer, Color and, with contours,
   * Contour (0 no contour goes through the pixel, 1 one does, 2 undecided); null before the
   * first frame and after one that failed. Positions and depths (along the unit ray) are in the
   * data's coordinates, elements are the cells of the source; of composite data, of the block that
   * a further array, Block, names by its flat index.
   *
   * A frame is traced with what drawing needs; the rest is traced by the first call for a frame, as
   * is what a coarse one lacks.
   */
  vtkImageData* GetBuffers();

  ///@{
  /**
   * How often, in this mapper's life, a model of a grid was made, a cut-surface was, rays were
   * traced, and a frame was coloured.
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
   * A box that holds the field's whole domain, curved faces included.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->vtkMapper::GetBounds(bounds); }
  ///@}

#ifndef __VTK_WRAP__
  /**
   * For programs that have an appearance of their own, as `pixelexact view` has: the mapper's
   * layers are drawn in it, whatever the settings of mapper, actor and layers are. Lights come from
   * the renderer. Null: by the settings. Render reports an appearance of another number of layers.
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
   * Opaque and translucent layers at once: for whoever knows no phases.
   */
  void RenderAll(vtkRenderer* renderer, vtkActor* actor);
  void RenderPart(int part, vtkRenderer* renderer, vtkActor* actor);
  /**
   * Of a frame: what is set and has no effect, and what it lacks.
   */
  std::vector<std::string> Complaints(const pixelexact::Renderer& frames, vtkActor* actor);
  void Warn(vtkRenderer* renderer, vtkActor* actor);
  /**
   * The range that colours are made with.
   */
  void TakeRange(const pixelexact::Renderer& frames);
  /**
   * The contours of a frame.
   */
  void TakeContours(const pixelexact::Renderer& frames);
  /**
   * What a frame may take in this window; infinite: as long as it takes.
   */
  double SecondsToTrace(vtkRenderWindow* window);

  /**
   * The first thing that a ray meets. Throws pixelexact::Error.
   */
  std::optional<pixelexact::PickedSample> PickSample(
    const pixelexact::PickRay& ray, vtkActor* actor);

  /**
   * What is shown, through a camera and without a renderer; null where it was aborted. Throws
   * pixelexact::Error.
   */
  vtkSmartPointer<vtkImageData> TracePicture(pixelexact::Renderer& frames,
    const pixelexact::CameraSight& sight, bool allBuffers,
    const std::function<bool(double)>& progress);

  /**
   * Where a picture shows something, in world space; empty where what is shown is wrong, of which
   * drawing it tells. Nothing is kept of it.
   */
  std::vector<std::array<double, 3>> SeenPoints(const pixelexact::CameraSight& sight);

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
