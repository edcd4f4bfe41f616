// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSubdivide
 * @brief   high-order elements cut into linear cells: a linear baseline
 *
 * Prepares grids for vtkCutter, vtkContourFilter and vtkDataSetMapper, which support linear cells
 * only. Points lie on the element's map, and fields have their exact values there, up to rounding.
 * Between points VTK interpolates linearly.
 *
 * Level l divides each edge into 2^l parts: a hexahedron becomes 8^l hexahedra, prisms become
 * wedges, tetrahedra become tetrahedra, and pyramids become pyramids and tetrahedra. Faces of
 * neighbours of the same level match. Points are shared within an element but not between elements,
 * where fields may jump. Filters that need one surface (vtkDataSetSurfaceFilter) require merged
 * points (vtkAppendFilter with MergePointsOn).
 *
 * With a Tolerance above 0 each element gets the lowest level that meets it. Cells of neighbours
 * then need not match, and cuts have cracks there, smaller than the tolerance.
 *
 * Arrays of the input's cells are copied to their linear cells; Element is the number of the source
 * cell. Point arrays that are not high-order fields are left out. Composite data become one grid
 * with the fields that all leaves have, and the cell arrays that all leaves have with the same type
 * and components.
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
   * The level, 0 to 5, of all elements; with a Tolerance the highest level. Default 2.
   */
  vtkSetClampMacro(Level, int, 0, 5);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Largest error of linear cells: in position, relative to the diagonal of the mesh's box, and in
   * the values of the fields, relative to their ranges. It is measured at the middles of edges and
   * cells; these samples prove nothing. 0, the default: all elements get the same level.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * For the last output: the number of elements that miss the Tolerance at the highest level.
   */
  vtkGetMacro(NumberOfCoarseElements, vtkIdType);

  ///@{
  /**
   * Names of the output's fields; none: all. A name that the grid lacks is an error.
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
