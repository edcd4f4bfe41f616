// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderCalculator
 * @brief   adds a field that is an expression of others, exact wherever it is evaluated
 *
 * The output is the input with the definition of a field, as text in its FieldData
 * (`PixelExact.Definition.NAME`): mappers, probes, filters and expressions take its name as they
 * take that of any field, and evaluate the expression from the polynomials where they need it. It
 * goes with the grid through pipelines, files and to other processes. The language is described in
 * Documentation/expressions.md: `mag(curl(vec(u,v,w)))`, `vonMises(displacement, 1.2, 0.8)`,
 * `u - sin(pi*x)*cos(pi*y)`.
 *
 * What needs a proof beyond values (certified ranges, contours as polylines) refuses such fields;
 * pixels with contours are undecided, iso-surfaces are searched, and integrals are numeric.
 *
 * The input is a grid that carries high-order coefficients, or a plain vtkUnstructuredGrid, which
 * is converted. Composite data are taken block by block.
 */

#ifndef vtkHighOrderCalculator_h
#define vtkHighOrderCalculator_h

#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // for texts

class vtkUnstructuredGrid;

class PIXELEXACTFILTERS_EXPORT vtkHighOrderCalculator
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  static vtkHighOrderCalculator* New();
  vtkTypeMacro(vtkHighOrderCalculator, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The name of the new field, which no field of the grid may have, nor one of an earlier
   * calculator; "result" by default.
   */
  vtkSetMacro(ResultArrayName, std::string);
  vtkGetMacro(ResultArrayName, std::string);
  ///@}

  ///@{
  /**
   * The expression. What is none is an error, with the place in the text.
   */
  vtkSetMacro(Function, std::string);
  vtkGetMacro(Function, std::string);
  ///@}

  ///@{
  /**
   * Whether point data with the field's name are added for filters that do not evaluate
   * definitions. They are its values at the grid's points in one of the cells that share a point;
   * NaN where a point is in no element. On Lagrange cells this is the nodal interpolant of their
   * order. On by default.
   */
  vtkSetMacro(PointValues, bool);
  vtkGetMacro(PointValues, bool);
  vtkBooleanMacro(PointValues, bool);
  ///@}

  /**
   * Adds, for each complex function of a grid, which is a pair of fields NAME_real and NAME_imag,
   * the definition NAME: its real part after a turn by `degrees`, NAME_real cos(degrees) -
   * NAME_imag sin(degrees). A definition of an earlier call is replaced; a function whose NAME is
   * another field's, or holds a quote, is left out. Returns the number of definitions.
   */
  static int DefinePhase(vtkUnstructuredGrid* grid, double degrees);

protected:
  vtkHighOrderCalculator();
  ~vtkHighOrderCalculator() override;

  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderCalculator(const vtkHighOrderCalculator&) = delete;
  void operator=(const vtkHighOrderCalculator&) = delete;

  std::string ResultArrayName = "result";
  std::string Function;
  bool PointValues = true;
};

#endif
