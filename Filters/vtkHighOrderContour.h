// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderContour
 * @brief   contour lines of a high-order field on a cut-surface, as polylines
 *
 * The input is a grid that carries high-order coefficients, a plain vtkUnstructuredGrid, which is
 * converted, or composite data of such grids, which are then one. The output is polylines: points
 * where the field has the value and the cut function is zero, both to rounding, joined through the
 * elements' faces; chords lie within the tolerance of the curves. Lines are closed, or end at the
 * mesh's boundary, where the field jumps, or where they could not be followed (told).
 *
 * Point data: an array of the field's name, the field's value; `Element` and, of composite data,
 * `Block`, as of vtkHighOrderProbe; `Xi`, reference coordinates in that element; `Gradient`, the
 * value's in world units. Cell data: `ContourValue`; `Closed`; `Certified`: 1 where it is proven
 * that the line has this course in the elements it passes and that none is missing in these.
 *
 * Planes, spheres, cylinders, cones of both halves, quadrics, tori, boxes and convex bodies, also
 * moved by affine transforms, are certified; lines end at the edges of boxes and bodies. Contours
 * on other functions' surfaces are searched for in samples and never certified. What is not
 * certified, or could not be decided, is counted and warned of.
 */

#ifndef vtkHighOrderContour_h
#define vtkHighOrderContour_h

#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the cut function

#include <string> // for the report
#include <vector> // for values

class vtkImplicitFunction;

namespace pixelexact
{
class ContourList;
}

class PIXELEXACTFILTERS_EXPORT vtkHighOrderContour
  : public PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm)
{
public:
  static vtkHighOrderContour* New();
  vtkTypeMacro(vtkHighOrderContour, PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the cut function's.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The function whose zeros are the cut-surface; there must be one.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  /**
   * The surfaces whose contours are certified, as a part of an error's message.
   */
  static std::string DescribeSurfaces();

  ///@{
  /**
   * The values, as of vtkContourFilter. None by default. They must be finite.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  double* GetValues();
  void GetValues(double* values);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int number, double range[2]);
  void GenerateValues(int number, double rangeStart, double rangeEnd);
  ///@}

  /**
   * A number of round values strictly inside a range, as the command-line program's --contours N
   * and vtkHighOrderContourMapper's ContourCount. GenerateValues makes evenly spaced ones, both
   * ends among them, as vtkContourFilter's.
   */
  void GenerateRoundValues(int number, double rangeStart, double rangeEnd);

  ///@{
  /**
   * The field. Empty, the default: that of SetInputArrayToProcess(0, ...), else the first one. A
   * name that the grid lacks is an error.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * Which component of a field, from 0, or -1, the default: the value of a scalar, the magnitude
   * of a vector.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * How far chords may be from the curves, in world units, measured at chords' middles: 1e-10 of
   * the diagonal of the grid's box or more. 0, the default: 1e-4 of it.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Of the last update: lines that are not certified; (element, value) pairs whose lines may not
   * all have been found; and a text with all that is known.
   */
  vtkGetMacro(NumberOfUncertifiedLines, vtkIdType);
  vtkGetMacro(NumberOfUndecidedElements, vtkIdType);
  vtkGetMacro(ReportText, std::string);
  ///@}

protected:
  vtkHighOrderContour();
  ~vtkHighOrderContour() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderContour(const vtkHighOrderContour&) = delete;
  void operator=(const vtkHighOrderContour&) = delete;

  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  std::unique_ptr<pixelexact::ContourList> Values;
  std::string FieldName;
  int Component = -1;
  double Tolerance = 0.0;
  vtkIdType NumberOfUncertifiedLines = 0;
  vtkIdType NumberOfUndecidedElements = 0;
  std::string ReportText;
};

#endif
