// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactRepresentation
 * @brief   shows a high-order field in ParaView's render views, by vtkHighOrderMapper
 *
 * Accepts a vtkUnstructuredGrid with high-order coefficients, a plain one, which is converted, or
 * composite data of such grids, which become one scene. A cut, the mesh's boundary or an
 * iso-surface is coloured by ParaView's array and colour map, or in one colour.
 *
 * Errors and warnings come from the mapper, the converter and, where ParaView's colour map omits
 * values of the field, from this class; they go to ParaView's messages. After an error nothing is
 * drawn.
 *
 * Each process draws its own elements: in parallel, data are not moved.
 */

#ifndef vtkPixelExactRepresentation_h
#define vtkPixelExactRepresentation_h

#include "PixelExactParaViewModule.h"
#include "vtkPVDataRepresentation.h"

#include <functional> // for the pointer
#include <memory>     // for the implementation
#include <string>     // for texts

class vtkActor;
class vtkHighOrderMapper;
class vtkImplicitFunction;
class vtkScalarsToColors;

class PIXELEXACTPARAVIEW_EXPORT vtkPixelExactRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkPixelExactRepresentation* New();
  vtkTypeMacro(vtkPixelExactRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;

  /**
   * The kinds of surfaces.
   */
  enum Surfaces
  {
    CUT = 0,             ///< where the cut function is zero
    BOUNDARY = 1,        ///< of the mesh, or those of its parts that have an attribute
    ISO_SURFACE = 2,     ///< where a field has a value
    SURFACE_OF_FILE = 3, ///< triangles or patches, see SetSurfaceFile
    SLICE_OR_CLIP = 4    ///< what PixelExact Slice and PixelExact Clip describe in the data
  };
  void SetSurface(int surface);

  /**
   * See vtkHighOrderMapper::SetCutFunction.
   */
  void SetCutFunction(vtkImplicitFunction* function);

  ///@{
  /**
   * Parts of the boundary; none: all of it. See vtkHighOrderBoundarySurface.
   */
  void AddBoundaryAttribute(int attribute);
  void RemoveAllBoundaryAttributes();
  ///@}

  ///@{
  /**
   * The iso-surface; see vtkHighOrderIsoSurface. Only the array's name is used; empty: the grid's
   * first field.
   */
  void SetIsoArray(int idx, int port, int connection, int association, const char* name);
  void SetIsoComponent(int component);
  void SetIsoValue(double value);
  ///@}

  ///@{
  /**
   * Whether walls close the iso-surface, in a colour of their own, where the field jumps across the
   * value; see vtkHighOrderJumpWalls. Several processes refuse it with a warning, because none of
   * them has both sides of all faces.
   */
  void SetJumpWalls(bool walls);
  void SetJumpWallColor(double red, double green, double blue);
  ///@}

  /**
   * A file of triangles (.stl, .vtp) or Bezier patches (.vtu, .vtp), in the data's coordinates.
   * Each process that draws reads it.
   */
  void SetSurfaceFile(const char* file);

  ///@{
  /**
   * Contours, edges, samples, bands and undecided pixels; see vtkHighOrderMapper.
   */
  void SetContourValue(int i, double value);
  void SetNumberOfContours(int number);
  void SetContourCount(int count);
  void SetContourWidth(double width);
  void SetContourColor(double red, double green, double blue);
  void SetContourScalarVisibility(bool visible);
  void SetContourLabels(bool labels);
  void SetContourLabelSize(int size);
  void SetContoursOnly(bool only);
  void SetContourInterior(bool interior);
  void SetShowUndecidedContours(bool show);
  void SetUndecidedContourColor(double red, double green, double blue);
  void SetEdgeVisibility(bool visible);
  void SetEdgesByKind(bool byKind);
  void SetSamples(int samples);
  void SetLightFlat(bool light);
  void SetBands(int bands);
  void SetShowUndecided(bool show);
  void SetUndecidedColor(double red, double green, double blue);
  ///@}

  ///@{
  /**
   * The field in colours: only the array's name is used. Empty: the DiffuseColor.
   */
  using Superclass::SetInputArrayToProcess;
  void SetInputArrayToProcess(
    int idx, int port, int connection, int association, const char* name) override;
  void SetLookupTable(vtkScalarsToColors* table);
  void SetMapScalars(bool map);
  ///@}

  /**
   * The range over the mesh of the field in colours, for the component that the colour map shows;
   * see pixelexact::FieldRange. 1 and -1 where there is no such field and, in several processes,
   * before the first picture.
   */
  double* GetFieldRange() VTK_SIZEHINT(2);

  /**
   * The range of the values in the last picture, in the colours of the colour map, over the parts
   * of all processes, although a nearer part may hide some; 1 and -1 where there are none.
   */
  double* GetVisibleRange() VTK_SIZEHINT(2);

  ///@{
  /**
   * The contents of a pixel of the view (from 0, the lower left one; below 0: none) after it was
   * rendered (in several processes: rendered after the pixel was set), see vtkHighOrderPicker.
   * Verdict (0 no cut, 1 exact, 2 undecided), element, xi (3), value, the two ends of an interval
   * that is proven to contain it (for scalar fields), position in the data's coordinates (3); NaN,
   * and -1 for the element, where there is none. The text has the same contents; it is empty where
   * there is no cut.
   */
  void SetPickedPixel(int x, int y);
  double* GetPicked() VTK_SIZEHINT(11);
  const char* GetPickedText();
  ///@}

  /**
   * The text of another pixel of the last picture. All processes that draw must call it.
   */
  const char* PickAt(int x, int y);

  ///@{
  /**
   * Texts over the picture: the meaning of colours outside the colour map; and the text of the
   * pixel under the pointer, while no button is down, in views with an interactor. PointerText is
   * the current text.
   */
  void SetVerdictLegend(bool show);
  void SetValueUnderPointer(bool show);
  const char* GetPointerText();
  ///@}

  /**
   * The function that returns a pixel's text where other processes draw; by default PickAt.
   */
  void SetPointerSource(std::function<std::string(int x, int y)> source);

  /**
   * The number of pixels of the last picture whose element is undecided; they are magenta. For
   * several processes the sum, although a nearer part may hide some.
   */
  vtkIdType GetNumberOfUnknownPixels();

  ///@{
  /**
   * Properties as in vtkProperty and vtkActor.
   */
  void SetAmbientColor(double red, double green, double blue);
  void SetDiffuseColor(double red, double green, double blue);
  void SetSpecularColor(double red, double green, double blue);
  void SetEdgeColor(double red, double green, double blue);
  void SetAmbient(double ambient);
  void SetDiffuse(double diffuse);
  void SetSpecular(double specular);
  void SetSpecularPower(double power);
  void SetInterpolation(int interpolation);
  void SetLineWidth(double width);
  void SetOpacity(double opacity);
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetUserTransform(const double matrix[16]);
  void SetPickable(bool pickable);
  ///@}

  ///@{
  /**
   * ParaView's choice of blocks and their colours. A warning refuses it, because blocks are one
   * scene.
   */
  void AddBlockSelector(const char* selector);
  void RemoveAllBlockSelectors();
  void SetBlockColor(const char* selector, double red, double green, double blue);
  void RemoveAllBlockColors();
  void SetBlockOpacity(const char* selector, double opacity);
  void RemoveAllBlockOpacities();
  ///@}

  ///@{
  /**
   * The mapper and the actor that draw.
   */
  vtkHighOrderMapper* GetMapper();
  vtkActor* GetActor();
  ///@}

protected:
  vtkPixelExactRepresentation();
  ~vtkPixelExactRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkPixelExactRepresentation(const vtkPixelExactRepresentation&) = delete;
  void operator=(const vtkPixelExactRepresentation&) = delete;

  void ChooseSurface(vtkDataObject* delivered);
  /**
   * Draws the slices that the data describe or, without slices, the clipped mesh.
   */
  void ChooseSliceOrClip(vtkDataObject* delivered);
  void ChooseWalls();
  void ReadSurfaceFile();
  std::string TextAt(int x, int y);
  void AfterRender();
  /**
   * Exchanges data on parts: which faces of a boundary lie between them and, for contours or edges,
   * elements beside them. All processes must call it.
   */
  void AskOthers();
  void AskOthersAgain(bool hadLines);
  /**
   * Warns about settings of ParaView's panels that do not apply to a cut, and about a colour map
   * that is too narrow. `shown` is null on processes without cells. All processes must call it; the
   * first one warns.
   */
  void Warn(vtkDataObject* shown);

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
