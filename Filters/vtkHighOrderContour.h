// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderContour
 * @brief   contour lines of a high-order field on a cut-surface, as polylines
 *
 * The input is a grid with high-order coefficients, a plain vtkUnstructuredGrid, which is
 * converted, or composite data of such grids, which are joined. The output is polylines. At their
 * points the field has the value and the cut function is zero, both to rounding. They are joined
 * across the elements' faces, and their chords lie within the tolerance of the curves. Lines are
 * closed, or end at the mesh's boundary, at jumps of the field, or where tracking failed (counted
 * and warned about).
 *
 * Point data: an array with the field's name and values; `Element` and, for composite data,
 * `Block`, as in vtkHighOrderProbe; `Xi`, reference coordinates in that element; `Gradient`, that
 * of the value in world units. Cell data: `ContourValue`; `Closed`; `Certified`: 1 where the line's
 * course in its elements is proven, and that no line is missing in these.
 *
 * Planes, spheres, cylinders, double cones, quadrics, tori, boxes and convex bodies are certified,
 * also after affine transforms; lines end at the edges of boxes and bodies. Contours on surfaces of
 * other functions are found by sampling and never certified. Lines that are not certified and
 * undecided elements are counted, with a warning.
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

  /// The cut function's modification time counts as well.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The function whose zeros are the cut-surface. It must be set.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  /**
   * The surfaces whose contours are certified, as part of an error message.
   */
  static std::string DescribeSurfaces();

  ///@{
  /**
   * The values, as in vtkContourFilter. None by default. They must be finite.
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
   * Sets a number of round values strictly inside a range, as --contours N of the command-line
   * program and ContourCount of vtkHighOrderContourMapper. GenerateValues sets evenly spaced
   * values, both ends included, as in vtkContourFilter.
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
   * The component of a field, from 0. -1, the default: the value of a scalar, the magnitude of a
   * vector.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Largest distance of chords from the curves, in world units, measured at chords' middles: at
   * least 1e-10 of the diagonal of the grid's box. 0, the default: 1e-4 of the diagonal.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Results of the last update: lines that are not certified; (element, value) pairs whose lines
   * may be incomplete; and a text with all details.
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
