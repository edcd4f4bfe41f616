// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderCertifier
 * @brief   what can be proven of each element: its validity, the ranges of det J and of a field
 *
 * The input is a grid that carries high-order coefficients, or a plain vtkUnstructuredGrid, which
 * is converted. The output is the input with these cell arrays, FIELD the field's name:
 *
 * - `Verdict`, unsigned char: 0 valid (det J > 0 everywhere), 1 inverted (det J <= 0 somewhere),
 *   2 undecided, 255 no element (a cell of lower dimension)
 * - `JacobianLower`, `JacobianUpper`: bounds that det J, as volume per volume of the reference
 *   shape, keeps
 * - `FIELD_lower`, `FIELD_upper`: bounds that the field's world values keep, per component
 *
 * Composite data are certified block by block.
 *
 * Bounds are proven, all rounding included, of what the coefficients define; -inf and inf where
 * none was found, NaN where a coefficient is not finite or the cell is no element. See
 * Documentation/proven.md.
 */

#ifndef vtkHighOrderCertifier_h
#define vtkHighOrderCertifier_h

#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // for the name

class PIXELEXACTFILTERS_EXPORT vtkHighOrderCertifier
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  static vtkHighOrderCertifier* New();
  vtkTypeMacro(vtkHighOrderCertifier, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The field whose bounds are added; none by default. A name that the grid lacks is an error.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * Largest distance of bounds from attained values, relative to the element's range of values.
   * From 1e-9 to 1, default 0.01.
   */
  vtkSetClampMacro(Tolerance, double, 1e-9, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The most boxes an element may be cut into, for each of its bounds and its verdict. From 1 to
   * 1000000, default 2000.
   */
  vtkSetClampMacro(MaximumBoxes, int, 1, 1000000);
  vtkGetMacro(MaximumBoxes, int);
  ///@}

protected:
  vtkHighOrderCertifier();
  ~vtkHighOrderCertifier() override;

  bool Make(vtkDataObject* input, Output* output) override;

private:
  vtkHighOrderCertifier(const vtkHighOrderCertifier&) = delete;
  void operator=(const vtkHighOrderCertifier&) = delete;

  std::string FieldName;
  double Tolerance = 0.01;
  int MaximumBoxes = 2000;
};

#endif
