// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderContourMapper
 * @brief   superclass of vtkHighOrderMapper: the settings of contours
 *
 * Contours are the lines on which the field has given values, drawn over the surfaces' colours.
 * Changes of values, colours and widths trace nothing. Coarse frames (see
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
   * The values. The functions are those of vtkContourFilter; the default is no values.
   * GenerateContourValues generates evenly spaced values, including both ends, as vtkContourFilter
   * does; SetContourCount chooses round values inside the range. Layers have the same values, or
   * their own (vtkHighOrderLayer). A value that is not finite causes an error when the frame is
   * drawn. A value that the field does not take draws nothing; duplicates are drawn once.
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
   * Above 0: replaces these values by this number of round values, strictly inside the range of the
   * colours of each frame (the layer's lookup table; in logarithms if its scale is logarithmic), as
   * the command-line program's --contours N. GetNumberOfContours, GetContourValue and
   * GetContourValues then return those of the last frame. 0, the default: the values above.
   */
  vtkSetClampMacro(ContourCount, int, 0, 10000);
  vtkGetMacro(ContourCount, int);
  ///@}

  ///@{
  /**
   * The contours' width in pixels, 0.1 to 32. Other widths cause an error when the frame is drawn.
   * The default is 1.5.
   */
  vtkSetMacro(ContourWidth, double);
  vtkGetMacro(ContourWidth, double);
  ///@}

  ///@{
  /**
   * The contours' colour; the default is black. The colour of a single contour takes precedence
   * until RemoveColorsOfContours. With ContourScalarVisibility on (the default is off), each
   * contour has its value's colour in the lookup table, even if surfaces have one colour.
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
   * Shows pixels for which it is undecided whether a contour crosses them in a colour of their own
   * (the default is teal). If off, the default, they show the lines that follow from the values at
   * pixels' corners; vtkHighOrderMapper::GetNumberOfUndecidedContourPixels returns their count.
   */
  vtkSetMacro(ShowUndecidedContours, bool);
  vtkGetMacro(ShowUndecidedContours, bool);
  vtkBooleanMacro(ShowUndecidedContours, bool);
  vtkSetVector3Macro(UndecidedContourColor, double);
  vtkGetVector3Macro(UndecidedContourColor, double);
  ///@}

  ///@{
  /**
   * Searches contours also inside pixels whose edges they do not cross: closed loops smaller than a
   * pixel, on planes and quadrics. Frames take longer. The default is off.
   */
  vtkSetMacro(ContourInterior, bool);
  vtkGetMacro(ContourInterior, bool);
  vtkBooleanMacro(ContourInterior, bool);
  ///@}

  ///@{
  /**
   * Factor on the work budget for pixels that are hard to decide, 0.001 to 1000. Pixels are
   * undecided when the budget is exhausted. The default is 1: about 40 s of one core for a frame.
   */
  vtkSetClampMacro(ContourEffort, double, 0.001, 1000.0);
  vtkGetMacro(ContourEffort, double);
  ///@}

  ///@{
  /**
   * From 0 to 8: pixels are proven as in the paper, by interval arithmetic along their edges, with
   * this number of subdivisions. -1, the default: by bounds of second derivatives, which decide
   * more pixels. Excludes ContourInterior.
   */
  vtkSetClampMacro(ContourSubdivisions, int, -1, 8);
  vtkGetMacro(ContourSubdivisions, int);
  ///@}

  ///@{
  /**
   * Draws contours without the colours of the surfaces, which are then transparent. The default is
   * off.
   */
  vtkSetMacro(ContoursOnly, bool);
  vtkGetMacro(ContoursOnly, bool);
  vtkBooleanMacro(ContoursOnly, bool);
  ///@}

  ///@{
  /**
   * Writes values along the contours where these are straight and apart, in letters
   * ContourLabelSize pixels high, 6 to 72; the defaults are off, and 12. If a layer is translucent,
   * there are no labels, and a warning is given.
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
   * The rule for surfaces without values of their own.
   */
  pixelexact::ContourRule ContoursOfAll() const;
  pixelexact::ContourAppearance AppearanceOfContours() const;
  /**
   * Takes over the drawn frame's values, by layer, for the functions that return the values of
   * ContourCount.
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
