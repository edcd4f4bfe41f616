// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderGrid
 * @brief   unstructured grid that carries high-order polynomials exactly
 *
 * Every element has a polynomial (or rational) map from its reference shape to the world and one
 * polynomial per field, kept as coefficients of an orthogonal modal basis in FieldData arrays. The
 * points and cells beside them are an ordinary vtkUnstructuredGrid: VTK's own filters see the
 * nodes, PixelExact's classes see the coefficients.
 *
 * All of it is in the arrays and nothing in the class: files, filters and ParaView that give back a
 * plain vtkUnstructuredGrid lose nothing, and every class of PixelExact accepts that. Where VTK's
 * filters dropped whole cells, the coefficients of the others are still good; where they moved
 * points, cut cells or changed nodal values, the coefficients are stale and refused
 * (CheckCoefficients()).
 *
 * Make one with vtkUnstructuredGridToHighOrderGrid.
 */

#ifndef vtkHighOrderGrid_h
#define vtkHighOrderGrid_h

#include "PixelExactDataModelModule.h"
#include "vtkUnstructuredGrid.h"

#include <memory> // for the model
#include <string> // for messages

class vtkDoubleArray;

namespace pixelexact
{
class HighOrderModel;
}

class PIXELEXACTDATAMODEL_EXPORT vtkHighOrderGrid : public vtkUnstructuredGrid
{
public:
  static vtkHighOrderGrid* New();
  vtkTypeMacro(vtkHighOrderGrid, vtkUnstructuredGrid);

  /**
   * Prints ten lines at most, in Python also for print(grid): cells by shape and order, the box of
   * the points, a box that is proven to contain the curved elements, the time, and fields with
   * components and orders. Of coefficients that do not fit, prints what is wrong. VTK's own arrays
   * print themselves.
   */
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether the grid carries high-order coefficients; says nothing of whether they still fit.
   */
  static bool IsHighOrder(vtkUnstructuredGrid* grid);

  /**
   * Whether the mesh of a grid, or of the first grid with cells of composite data, is a surface in
   * space: triangles and quadrilaterals that do not lie in a plane z = const. Such a mesh is shown
   * as its boundary (vtkHighOrderBoundarySurface); cut-surfaces and iso-surfaces refuse it.
   */
  static bool IsSurfaceInSpace(vtkDataObject* data);

  /**
   * Empty when the coefficients in the grid's arrays are whole and belong to its cells, points and
   * nodal values; otherwise what is wrong, with the cell, field or array and the remedy.
   */
  static std::string CheckCoefficients(vtkUnstructuredGrid* grid);

  ///@{
  /**
   * Names of the fields that have coefficients. None where CheckCoefficients() has something to
   * say: that is reported as an error.
   */
  int GetNumberOfHighOrderFields();
  std::string GetHighOrderFieldName(int index);
  ///@}

  /**
   * Number of components of a field; 0, and an error, where there is none of that name.
   */
  int GetHighOrderFieldComponents(const std::string& name);

  /**
   * The lowest and the highest polynomial order of any element's geometry; (0, -1) when empty.
   */
  void GetGeometryOrderRange(int range[2]) VTK_SIZEHINT(range, 2);

  /**
   * The lowest and the highest polynomial order of a field; (0, -1) where there is none.
   */
  void GetFieldOrderRange(const std::string& name, int range[2]) VTK_SIZEHINT(range, 2);

  /**
   * The world point x of reference coordinates xi of an element (= cell number of this grid). The
   * reference shapes are those of Core/Shape/Shape.h: hexahedron [-1,1]^3, the others cut from it.
   * xi outside of the shape is extrapolated. False, with an error, when there is no such element.
   */
  bool MapForward(vtkIdType element, const double xi[3], double x[3]);

  /**
   * The field's value at reference coordinates xi of an element: one tuple, of the field's
   * components. False, with an error, when there is no such field or element.
   */
  bool EvaluateField(
    const std::string& name, vtkIdType element, const double xi[3], vtkDoubleArray* values);

#ifndef __VTK_WRAP__
  /**
   * The views that the numerics work on, made on first need and again after changes. Throws
   * pixelexact::Error; see HighOrderModel::From.
   */
  std::shared_ptr<pixelexact::HighOrderModel> GetModel();
#endif

protected:
  vtkHighOrderGrid();
  ~vtkHighOrderGrid() override;

private:
  vtkHighOrderGrid(const vtkHighOrderGrid&) = delete;
  void operator=(const vtkHighOrderGrid&) = delete;

  /// A cache: everything in it comes from the arrays.
  std::shared_ptr<pixelexact::HighOrderModel> Model;
};

#endif
