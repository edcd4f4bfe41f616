// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderExtremes
 * @brief   the minimum and the maximum of a high-order field over a mesh, with proven bounds
 *
 * The input is a grid with high-order coefficients, a plain vtkUnstructuredGrid, which is
 * converted, or composite data of such grids, which are joined. The output has a vertex where the
 * field attains a value next to its minimum, and one for its maximum; none where no value is
 * finite. Point data:
 *
 * - `Value`: the field at the point
 * - `Bound`: proven; the field has no value below it (at a maximum: above it); infinite where no
 *   bound was found
 * - `Attained`: proven; the field attains a value not above it (at a maximum: not below it), at the
 *   point up to rounding. The extreme lies between `Bound` and `Attained`
 * - `Gap`: |Attained - Bound|, rounded up
 * - `Element`, the number of the cell in the source, and `Xi`, reference coordinates in it
 * - `Maximum`: 0 at the minimum, 1 at the maximum
 *
 * Gaps are at most 1e-9 of the range of values or 2^-40 of the largest magnitude, unless the work
 * budget is exhausted (ToleranceMet). Of a discontinuous field a value is that of its element.
 * Expressions whose ranges cannot be proven are errors.
 */

#ifndef vtkHighOrderExtremes_h
#define vtkHighOrderExtremes_h

#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the name

class PIXELEXACTFILTERS_EXPORT vtkHighOrderExtremes
  : public PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm)
{
public:
  static vtkHighOrderExtremes* New();
  vtkTypeMacro(vtkHighOrderExtremes, PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The field, or an expression. Empty, the default: that of SetInputArrayToProcess(0, ...), else
   * the first one.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * The component of a field, from 0. -1, the default: a scalar itself, or the magnitude.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Results of the last update: whether both gaps are as small as stated; elements with a
   * coefficient that is not finite, which are left out; elements of which no bound was found;
   * elements that are proven inverted, and those that are neither proven valid nor inverted.
   */
  vtkGetMacro(ToleranceMet, bool);
  vtkGetMacro(NotFiniteElements, vtkIdType);
  vtkGetMacro(UnboundedElements, vtkIdType);
  vtkGetMacro(InvertedElements, vtkIdType);
  vtkGetMacro(UndecidedElements, vtkIdType);
  ///@}

protected:
  vtkHighOrderExtremes();
  ~vtkHighOrderExtremes() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderExtremes(const vtkHighOrderExtremes&) = delete;
  void operator=(const vtkHighOrderExtremes&) = delete;

  std::string FieldName;
  int Component = -1;
  bool ToleranceMet;
  vtkIdType NotFiniteElements;
  vtkIdType UnboundedElements;
  vtkIdType InvertedElements;
  vtkIdType UndecidedElements;
};

#endif
