// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderProbe
 * @brief   exact values of high-order fields at given points
 *
 * Port 0 takes the points (any data set), port 1 the grid: one that carries high-order
 * coefficients, or a plain vtkUnstructuredGrid, which is converted, or composite data of such
 * grids, which are then one (with the fields that all have). The output has the structure of port 0
 * and these point arrays, FIELD the name of each field:
 *
 * - `FIELD`: value; NaN where the point is not inside
 * - `FIELD_Gradient`: on request, 3 per component: d/dx, d/dy, d/dz
 * - `FIELD_lower`, `FIELD_upper`: on request, an interval per component that is proven to hold
 *   the field's value at the point, the error of the inverse map included; infinite where nothing
 *   is proven, NaN where the point is not inside
 * - `Xi`: reference coordinates in the element; NaN where not inside
 * - `Element`: number of the cell in the source; -1 outside
 * - `Block`: where the grid is composite data, the flat index of the block that the element is in
 * - `Verdict`: 0 outside, 1 inside, 2 unknown: could not be decided in the budget; Element is then
 *   one that may hold the point
 * - `Residual`: last correction of Newton's iteration, in xi
 * - `Owners`, `Coverage`: on request, how many preimages the point has in all elements, and 0 none
 *   (outside, or a gap), 1 once, 2 several (an overlap, or a fold), 3 undecided
 *
 * A field that has the name of another of these arrays is refused.
 */

#ifndef vtkHighOrderProbe_h
#define vtkHighOrderProbe_h

#include "FieldSelection.h"
#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // for names

class vtkDataObject;
class vtkDataSet;

class PIXELEXACTFILTERS_EXPORT vtkHighOrderProbe
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  static vtkHighOrderProbe* New();
  vtkTypeMacro(vtkHighOrderProbe, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The grid: port 1.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkDataObject* grid);
  ///@}

  ///@{
  /**
   * Names of the fields to evaluate; none: all. A name that the grid lacks is an error.
   */
  void AddField(const std::string& name) { this->Fields.Add(name); }
  void ClearFields() { this->Fields.Clear(); }
  ///@}

  ///@{
  /**
   * Whether to add gradients. Off by default.
   */
  vtkSetMacro(ComputeGradients, bool);
  vtkGetMacro(ComputeGradients, bool);
  vtkBooleanMacro(ComputeGradients, bool);
  ///@}

  ///@{
  /**
   * Whether to add enclosures of the values: some 20 to 50 times the cost of a value. Off by
   * default.
   */
  vtkSetMacro(Enclosures, bool);
  vtkGetMacro(Enclosures, bool);
  vtkBooleanMacro(Enclosures, bool);
  ///@}

  ///@{
  /**
   * Whether to count the owners of each point: for meshes that are being debugged. Off by default.
   */
  vtkSetMacro(Owners, bool);
  vtkGetMacro(Owners, bool);
  vtkBooleanMacro(Owners, bool);
  ///@}

protected:
  vtkHighOrderProbe();
  ~vtkHighOrderProbe() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderProbe(const vtkHighOrderProbe&) = delete;
  void operator=(const vtkHighOrderProbe&) = delete;

  pixelexact::FieldSelection Fields{ this };
  bool ComputeGradients = false;
  bool Enclosures = false;
  bool Owners = false;
  bool PointsAreInBlocks = false; ///< in a parallel run
};

#endif
