// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderPlotOverLine
 * @brief   exact values of high-order fields along a line
 *
 * The input is a grid that carries high-order coefficients, a plain vtkUnstructuredGrid, which is
 * converted, or composite data of such grids, which are then one. The output is one polyline from
 * Point1 to Point2 with Resolution + 1 evenly spaced points and, with ElementBoundaries, two more
 * wherever the line passes from one element into another, or out of the mesh: the last of the one
 * and the first of the other, so that a field that jumps is drawn as it is.
 *
 * Point arrays: `arc_length`, the distance from Point1, and those of vtkHighOrderProbe: `FIELD`
 * (NaN outside), `Element`, `Xi`, `Verdict`, `Residual`, on request `FIELD_Gradient`, `FIELD_lower`
 * and `FIELD_upper`. An element that lies between two of the evenly spaced points and holds neither
 * of them may be passed over.
 */

#ifndef vtkHighOrderPlotOverLine_h
#define vtkHighOrderPlotOverLine_h

#include "FieldSelection.h"
#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string> // for names

class PIXELEXACTFILTERS_EXPORT vtkHighOrderPlotOverLine
  : public PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm)
{
public:
  static vtkHighOrderPlotOverLine* New();
  vtkTypeMacro(vtkHighOrderPlotOverLine, PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The ends of the line; they must be finite, and differ. Defaults: (0, 0, 0) and (1, 0, 0).
   */
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /**
   * Into how many pieces the line is divided, 1 to 10 million. Default 1000.
   */
  vtkSetClampMacro(Resolution, int, 1, 10000000);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Whether there are points at both sides of elements' boundaries. On by default.
   */
  vtkSetMacro(ElementBoundaries, bool);
  vtkGetMacro(ElementBoundaries, bool);
  vtkBooleanMacro(ElementBoundaries, bool);
  ///@}

  ///@{
  /**
   * Names of the fields; none: all. A name that the grid lacks is an error.
   */
  void AddField(const std::string& name) { this->Fields.Add(name); }
  void ClearFields() { this->Fields.Clear(); }
  ///@}

  ///@{
  /**
   * Gradients, and enclosures of values; see vtkHighOrderProbe. Off by default.
   */
  vtkSetMacro(ComputeGradients, bool);
  vtkGetMacro(ComputeGradients, bool);
  vtkBooleanMacro(ComputeGradients, bool);
  vtkSetMacro(Enclosures, bool);
  vtkGetMacro(Enclosures, bool);
  vtkBooleanMacro(Enclosures, bool);
  ///@}

protected:
  vtkHighOrderPlotOverLine();
  ~vtkHighOrderPlotOverLine() override;

  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderPlotOverLine(const vtkHighOrderPlotOverLine&) = delete;
  void operator=(const vtkHighOrderPlotOverLine&) = delete;

  double Point1[3] = { 0.0, 0.0, 0.0 };
  double Point2[3] = { 1.0, 0.0, 0.0 };
  int Resolution = 1000;
  bool ElementBoundaries = true;
  bool ComputeGradients = false;
  bool Enclosures = false;
  pixelexact::FieldSelection Fields{ this };
};

#endif
