// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSubdivide
 * @brief   high-order elements cut into linear cells: a linear baseline
 *
 * What is done before vtkCutter, vtkContourFilter and vtkDataSetMapper, which know linear cells
 * alone. Points lie where the element has them and fields have their exact values there, up to
 * rounding; between them VTK interpolates linearly. What that costs is what vtkHighOrderGrid is
 * for.
 *
 * At level l each edge becomes 2^l: hexahedra become 8^l hexahedra, prisms wedges, tetrahedra
 * tetrahedra, and pyramids pyramids and tetrahedra. Faces of neighbours of one level fit. Points
 * are shared within an element but not between elements, where fields may jump; what wants one
 * surface (vtkDataSetSurfaceFilter) merges them first (vtkAppendFilter with MergePointsOn).
 *
 * With a Tolerance above 0 each element gets the lowest level that meets it: the cells of
 * neighbours then need not fit, and cuts have cracks there, smaller than the tolerance.
 *
 * Arrays of the input's cells go to their parts; Element tells the source's cell. Point arrays that
 * are no high-order fields are left out. Of composite data one grid is made, with the fields, and
 * cell arrays of the same type and components, that all leaves have.
 */

#ifndef vtkHighOrderSubdivide_h
#define vtkHighOrderSubdivide_h

#include "FieldSelection.h"
#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for names

namespace pixelexact
{
class HighOrderModel;
}

class PIXELEXACTFILTERS_EXPORT vtkHighOrderSubdivide
  : public PIXELEXACT_MESH_FILTER(vtkUnstructuredGridAlgorithm)
{
public:
  static vtkHighOrderSubdivide* New();
  vtkTypeMacro(vtkHighOrderSubdivide, PIXELEXACT_MESH_FILTER(vtkUnstructuredGridAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The level, 0 to 5, of all elements, or with a Tolerance the highest of any. Default 2.
   */
  vtkSetClampMacro(Level, int, 0, 5);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * How far linear cells may be off: in place, over the diagonal of the mesh's box, and in the
   * values of the fields, over their ranges. Classified at the middles of edges and cells: samples,
   * which prove nothing. 0, the default: all elements get the same level.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * Of the last output: elements that miss the Tolerance at the highest level.
   */
  vtkGetMacro(NumberOfCoarseElements, vtkIdType);

  ///@{
  /**
   * Names of the fields that the output has; none: all. A name that the grid lacks is an error.
   */
  void AddField(const std::string& name) { this->Fields.Add(name); }
  void ClearFields() { this->Fields.Clear(); }
  ///@}

protected:
  vtkHighOrderSubdivide();
  ~vtkHighOrderSubdivide() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderSubdivide(const vtkHighOrderSubdivide&) = delete;
  void operator=(const vtkHighOrderSubdivide&) = delete;

  int Level = 2;
  double Tolerance = 0.0;
  vtkIdType NumberOfCoarseElements = 0;
  pixelexact::FieldSelection Fields{ this };
};

#endif
