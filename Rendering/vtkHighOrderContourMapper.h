// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderContourMapper
 * @brief   superclass of vtkHighOrderMapper: what is asked for of contours
 *
 * Contours are the lines on which the field has given values, drawn over the surfaces' colours.
 * Other values, colours and widths trace nothing. Coarse frames (see
 * vtkHighOrderMapper::SetProgressive) have no contours.
 */

#ifndef vtkHighOrderContourMapper_h
#define vtkHighOrderContourMapper_h

#include "PixelExactRenderingModule.h"
#include "vtkMapper.h"

#include <memory> // for the values
#include <vector> // for those of layers

namespace pixelexact
{
class ContourList;
struct ContourAppearance;
struct ContourRule;
} // namespace pixelexact

class vtkDataArray;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderContourMapper : public vtkMapper
{
public:
  vtkTypeMacro(vtkHighOrderContourMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The values. The functions are those of vtkContourFilter; there are none by default.
   * GenerateContourValues makes evenly spaced values, both ends among them, as that does; a number
   * of round values inside the range is SetContourCount's. Layers have the same
   * values, or their own (vtkHighOrderLayer). A value that is not finite is an error when it is
   * drawn; one that the field does not have draws nothing, one that is there twice is drawn once.
   */
  void SetContourValue(int i, double value);
  double GetContourValue(int i);
  void SetContourValues(vtkDataArray* values);
  double* GetContourValues() VTK_SIZEHINT(GetNumberOfContours());
  void SetNumberOfContours(int number);
  int GetNumberOfContours();
  void GenerateContourValues(int number, double lower, double upper);
  void GenerateContourValues(int number, const double range[2]);
  ///@}

  ///@{
  /**
   * Above 0: instead of these values so many round ones, strictly inside the range of the colours
   * of each frame (the layer's lookup table; by logarithms where it has a logarithmic scale), as
   * the command-line program's --contours N. GetNumberOfContours, GetContourValue and
   * GetContourValues give those of the last frame then. 0, the default: the values that are set.
   */
  vtkSetClampMacro(ContourCount, int, 0, 10000);
  vtkGetMacro(ContourCount, int);
  ///@}

  ///@{
  /**
   * The contours' width in pixels, 0.1 to 32; another one is an error when it is drawn. The default
   * is 1.5.
   */
  vtkSetMacro(ContourWidth, double);
  vtkGetMacro(ContourWidth, double);
  ///@}

  ///@{
  /**
   * The contours' colour; the default is black. That of a single one goes before it, until
   * RemoveColorsOfContours; and with ContourScalarVisibility on (the default is off) each has the
   * colour that its value has in the lookup table, also where surfaces have one colour.
   */
  vtkSetVector3Macro(ContourColor, double);
  vtkGetVector3Macro(ContourColor, double);
  void SetColorOfContour(int i, double red, double green, double blue);
  void RemoveColorsOfContours();
  vtkSetMacro(ContourScalarVisibility, bool);
  vtkGetMacro(ContourScalarVisibility, bool);
  vtkBooleanMacro(ContourScalarVisibility, bool);
  ///@}

  ///@{
  /**
   * Whether pixels of which it could not be decided whether a contour goes through them have a
   * colour of their own (the default is teal). Else, the default, they show the lines between the
   * values at pixels' corners, as if none was missing; how many there are
   * vtkHighOrderMapper::GetNumberOfUndecidedContourPixels tells.
   */
  vtkSetMacro(ShowUndecidedContours, bool);
  vtkGetMacro(ShowUndecidedContours, bool);
  vtkBooleanMacro(ShowUndecidedContours, bool);
  vtkSetVector3Macro(UndecidedContourColor, double);
  vtkGetVector3Macro(UndecidedContourColor, double);
  ///@}

  ///@{
  /**
   * Whether contours are looked for inside of pixels, too, on whose edges there are none: closed
   * loops smaller than a pixel, on planes and quadrics. Frames take longer. The default is off.
   */
  vtkSetMacro(ContourInterior, bool);
  vtkGetMacro(ContourInterior, bool);
  vtkBooleanMacro(ContourInterior, bool);
  ///@}

  ///@{
  /**
   * How many times as much as usual may be spent on pixels that are hard to decide, 0.001 to 1000.
   * What is left is undecided. The default is 1: about 40 s of one core for a frame.
   */
  vtkSetClampMacro(ContourEffort, double, 0.001, 1000.0);
  vtkGetMacro(ContourEffort, double);
  ///@}

  ///@{
  /**
   * From 0 to 8: pixels are proven as in the paper, by interval arithmetic along their edges, which
   * are halved so many times. -1, the default: by bounds of second derivatives, which decide more.
   * Not with ContourInterior.
   */
  vtkSetClampMacro(ContourSubdivisions, int, -1, 8);
  vtkGetMacro(ContourSubdivisions, int);
  ///@}

  ///@{
  /**
   * Whether contours are drawn without the colours of the surfaces, which are transparent then. The
   * default is off.
   */
  vtkSetMacro(ContoursOnly, bool);
  vtkGetMacro(ContoursOnly, bool);
  vtkBooleanMacro(ContoursOnly, bool);
  ///@}

  ///@{
  /**
   * Whether values are written along the contours, where these are straight and apart, in letters
   * ContourLabelSize pixels high, 6 to 72; the defaults are off, and 12. Not where a layer is seen
   * through: a warning says so.
   */
  vtkSetMacro(ContourLabels, bool);
  vtkGetMacro(ContourLabels, bool);
  vtkBooleanMacro(ContourLabels, bool);
  vtkSetMacro(ContourLabelSize, int);
  vtkGetMacro(ContourLabelSize, int);
  ///@}

  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkHighOrderContourMapper();
  ~vtkHighOrderContourMapper() override;

#ifndef __VTK_WRAP__
  /**
   * On surfaces without values of their own.
   */
  pixelexact::ContourRule ContoursOfAll() const;
  pixelexact::ContourAppearance AppearanceOfContours() const;
  /**
   * By layer, of the frame that was drawn: for those who ask for the values of ContourCount.
   */
  void TakeContours(const std::vector<std::vector<double>>& drawn);
#endif

  int ContourCount = 0;
  double ContourWidth = 1.5;
  double ContourColor[3] = { 0.0, 0.0, 0.0 };
  bool ContourScalarVisibility = false;
  bool ShowUndecidedContours = false;
  double UndecidedContourColor[3] = { 0.0, 0.5, 0.5 };
  bool ContourInterior = false;
  double ContourEffort = 1.0;
  int ContourSubdivisions = -1;
  bool ContoursOnly = false;
  bool ContourLabels = false;
  int ContourLabelSize = 12;

private:
  vtkHighOrderContourMapper(const vtkHighOrderContourMapper&) = delete;
  void operator=(const vtkHighOrderContourMapper&) = delete;

  pixelexact::ContourList& ShownContours();

  struct Internals;
  std::unique_ptr<Internals> Contours;
};

#endif
