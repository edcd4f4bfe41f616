// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactRepresentation
 * @brief   shows a high-order field in ParaView's render views, by vtkHighOrderMapper
 *
 * Takes a vtkUnstructuredGrid that carries high-order coefficients, or a plain one, which is
 * converted, or composite data of such grids, which are then one scene. A cut, the mesh's boundary
 * or an iso-surface is coloured by ParaView's array and colour map, or in one colour.
 *
 * Errors and warnings are those of the mapper, the converter and, where ParaView's colour map
 * leaves out values that the field has, of this class; they go to ParaView's messages. After an
 * error nothing is drawn.
 *
 * Each process draws the elements that it has: in parallel, data are not moved.
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
   * What is shown.
   */
  enum Surfaces
  {
    CUT = 0,            ///< where the cut function is zero
    BOUNDARY = 1,       ///< of the mesh, or those of its parts that have an attribute
    ISO_SURFACE = 2,    ///< where a field has a value
    SURFACE_OF_FILE = 3 ///< triangles or patches, see SetSurfaceFile
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
   * The iso-surface; see vtkHighOrderIsoSurface. Of the array only the name counts; empty: the
   * grid's first field.
   */
  void SetIsoArray(int idx, int port, int connection, int association, const char* name);
  void SetIsoComponent(int component);
  void SetIsoValue(double value);
  ///@}

  ///@{
  /**
   * With the iso-surface, in a colour of their own, the walls that close it where the field jumps
   * across the value; see vtkHighOrderJumpWalls. Refused by a warning where several processes draw:
   * none of them knows both sides of all faces.
   */
  void SetJumpWalls(bool walls);
  void SetJumpWallColor(double red, double green, double blue);
  ///@}

  /**
   * A file of triangles (.stl, .vtp) or Bezier patches (.vtu, .vtp), in the data's coordinates,
   * that each process which draws reads.
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
   * Which field colours: only the array's name counts. Empty: the DiffuseColor.
   */
  using Superclass::SetInputArrayToProcess;
  void SetInputArrayToProcess(
    int idx, int port, int connection, int association, const char* name) override;
  void SetLookupTable(vtkScalarsToColors* table);
  void SetMapScalars(bool map);
  ///@}

  /**
   * The ends of the values that the field in colours has over the mesh, of the component that the
   * colour map shows; see pixelexact::FieldRange. 1 and -1 where there is no such field; in several
   * processes, of whose parts it is put together, also before the first picture.
   */
  double* GetFieldRange() VTK_SIZEHINT(2);

  /**
   * The ends of the values that the last picture shows in the colours of the colour map, in the
   * parts of all processes, although a nearer part may hide some; 1 and -1 where there are none.
   */
  double* GetVisibleRange() VTK_SIZEHINT(2);

  ///@{
  /**
   * What a pixel of the view shows (from 0, the lower left one; below 0: none), once it was
   * rendered (in several processes: after the pixel was set), see vtkHighOrderPicker: verdict (0 no
   * cut, 1 exact, 2 undecided), element, xi (3), value, the two ends of an interval proven to hold
   * it (of scalar fields), position in the data's coordinates (3); NaN, of the element -1, where
   * there is none. And the same as a text, empty where there is no cut.
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
   * What is written over the picture: what colours beside the map mean; and the text of the pixel
   * under the pointer, while no button is down, in views with an interactor. PointerText is what is
   * written.
   */
  void SetVerdictLegend(bool show);
  void SetValueUnderPointer(bool show);
  const char* GetPointerText();
  ///@}

  /**
   * Who knows the text of a pixel where others draw, or not this process alone; by default PickAt.
   */
  void SetPointerSource(std::function<std::string(int x, int y)> source);

  /**
   * Of the last picture: pixels whose element could not be decided; they are magenta. Of several
   * processes the sum, although a nearer part may hide some.
   */
  vtkIdType GetNumberOfUnknownPixels();

  ///@{
  /**
   * As those of vtkProperty and vtkActor.
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
   * ParaView's choice of blocks and their colours, which are refused by a warning: blocks are one
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
   * What draws.
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

  void ChooseSurface();
  void ChooseWalls();
  void ReadSurfaceFile();
  std::string TextAt(int x, int y);
  void AfterRender();
  /**
   * What several processes, all of which call it, tell each other of their parts: which faces of a
   * boundary lie between these; where there are contours or edges, elements beside them.
   */
  void AskOthers();
  void AskOthersAgain(bool hadLines);
  /**
   * Of what ParaView's panels offer and a cut does not have, and of a colour map that is too
   * narrow. Of what is null on processes without cells, all of which call it; the first one warns.
   */
  void Warn(vtkDataObject* shown);

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
