// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkUnstructuredGridToHighOrderGrid
 * @brief   gives an unstructured grid its exact high-order polynomials
 *
 * Takes linear, quadratic, Lagrange and Bezier tetrahedra, hexahedra, wedges and pyramids (Lagrange
 * and Bezier: no pyramids; Bezier with unequal weights: hexahedra and quadrilaterals, see
 * files.md) and makes a vtkHighOrderGrid of the same points and cells, with the coefficients of
 * the geometry and of the fields. Point data become fields of
 * the cells' orders, cell data fields that are constant in each cell. Cells of lower dimension are
 * left out and counted. A grid without solid cells whose triangles and quadrilaterals (linear,
 * quadratic, Lagrange, Bezier) lie in a plane z = const becomes a thin slab on it (files.md): its
 * cells stay plane, its coefficients are those of prisms and hexahedra.
 *
 * A grid that carries coefficients already may have been changed since by filters. If they come
 * from nodal values, it is converted again. A solver's own coefficients are kept, and changes are
 * followed:
 *
 * - If all points were moved by an affine motion (vtkTransformFilter), the coefficients of the map
 *   move with them.
 * - If points were moved otherwise (vtkWarpVector), the map is the polynomial through the cells'
 *   points; the cells must be Lagrange cells of the elements' order.
 * - Arrays of point data that are new or have other values than their field become fields: the
 *   polynomials through their values at the cells' points. Warnings name changed ones.
 *
 * H(curl), H(div) and density fields of moved grids are left out, with a warning. Grids whose cells
 * were cut (vtkClipDataSet), and other changes of grids with linear cells beside curved elements,
 * are errors.
 *
 * Where the cells and points are those of the last execution, as in the next time step of a series,
 * the output holds the same mesh arrays again, only fields are converted, and whoever locates
 * points in it (vtkHighOrderMapper, vtkHighOrderProbe) goes on with the locator that it has.
 *
 * Composite data are converted block by block. GetHighOrderOutput() is null then, and counts and
 * diagnostics are those of the last block; all are reported as warnings.
 *
 * What looks wrong in the file but can be converted is reported as warnings and by GetDiagnostic().
 */

#ifndef vtkUnstructuredGridToHighOrderGrid_h
#define vtkUnstructuredGridToHighOrderGrid_h

#include "FieldSelection.h"
#include "PixelExactFiltersModule.h"
#include "vtkHighOrderGridAlgorithm.h"

#include <map>    // for counts
#include <memory> // for the mesh
#include <string> // for names

namespace pixelexact
{
class KeptMesh;
}

class PIXELEXACTFILTERS_EXPORT vtkUnstructuredGridToHighOrderGrid : public vtkHighOrderGridAlgorithm
{
public:
  static vtkUnstructuredGridToHighOrderGrid* New();
  vtkTypeMacro(vtkUnstructuredGridToHighOrderGrid, vtkHighOrderGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether a grid carries coefficients that fit its cells and arrays, and no array that could be a
   * field as well. Of others, this filter makes such a grid.
   */
  static bool IsConverted(vtkUnstructuredGrid* grid);

  ///@{
  /**
   * Names of the arrays of point and cell data to convert. None: all that are numeric and no
   * bookkeeping (ids, ghost flags, weights, degrees). A name that the input lacks is an error.
   */
  void AddField(const std::string& name) { this->Fields.Add(name); }
  void ClearFields() { this->Fields.Clear(); }
  ///@}

  ///@{
  /**
   * Where the nodes of Lagrange cells are: equispaced (the default), as VTK has it, or at the
   * Gauss-Lobatto-Legendre points, as Trixi, DOLFINx (above order 2) and other codes leave them.
   * For hexahedra of any order; wedges and tetrahedra to order 3 in their triangles, above which
   * solvers place the nodes inside differently: these are an error. Other cells, and a solver's own
   * coefficients, know no such choice. A warning names this where the nodes on straight edges
   * suggest the other place.
   */
  enum NodePlacements
  {
    EQUISPACED = 0,
    GAUSS_LOBATTO = 1
  };
  vtkSetClampMacro(NodePlacement, int, EQUISPACED, GAUSS_LOBATTO);
  vtkGetMacro(NodePlacement, int);
  void SetNodePlacementToEquispaced() { this->SetNodePlacement(EQUISPACED); }
  void SetNodePlacementToGaussLobatto() { this->SetNodePlacement(GAUSS_LOBATTO); }
  ///@}

  ///@{
  /**
   * Whether Lagrange wedges of order 3 and more have the nodes inside their quadrilateral r = 0
   * mirrored along s, as MFEM writes them. Off by default, as VTK has it. A warning names this
   * where the wedges would be much smoother the other way.
   */
  vtkSetMacro(MirroredWedges, bool);
  vtkGetMacro(MirroredWedges, bool);
  vtkBooleanMacro(MirroredWedges, bool);
  ///@}

  ///@{
  /**
   * Whether a grid of solids and surface elements (triangles, quadrilaterals) becomes one of its
   * surface elements. Off by default: it becomes one of its solids, and a warning states how many
   * surface elements are left out. It is an error where there are none.
   */
  vtkSetMacro(SurfaceElements, bool);
  vtkGetMacro(SurfaceElements, bool);
  vtkBooleanMacro(SurfaceElements, bool);
  ///@}

  ///@{
  /**
   * Whether to look for signs of a faulty file (mirrored wedges, warped nodes, inverted elements).
   * On by default.
   */
  vtkSetMacro(Diagnose, bool);
  vtkGetMacro(Diagnose, bool);
  vtkBooleanMacro(Diagnose, bool);
  ///@}

  ///@{
  /**
   * Results of the last execution: number of cells left out; number of elements with a coefficient
   * that is NaN or infinite.
   */
  vtkGetMacro(NumberOfSkippedCells, vtkIdType);
  int GetNumberOfNonFiniteElements(const std::string& field);
  ///@}

protected:
  vtkUnstructuredGridToHighOrderGrid();
  ~vtkUnstructuredGridToHighOrderGrid() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkUnstructuredGridToHighOrderGrid(const vtkUnstructuredGridToHighOrderGrid&) = delete;
  void operator=(const vtkUnstructuredGridToHighOrderGrid&) = delete;

  pixelexact::FieldSelection Fields{ this };
  int NodePlacement = EQUISPACED;
  bool MirroredWedges = false;
  bool SurfaceElements = false;
  bool Diagnose = true;
  vtkIdType NumberOfSkippedCells = 0;
  std::map<std::string, int> NonFiniteElements;
  std::unique_ptr<pixelexact::KeptMesh> Kept; ///< of the last execution
};

#endif
