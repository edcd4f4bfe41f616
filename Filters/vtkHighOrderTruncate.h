// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderTruncate
 * @brief   high-order fields without their top modes, and how much that changes
 *
 * Drops, element by element, the modes above an order of an orthogonal basis (of Legendre's and
 * Dubiner's kind, see Core/Basis/Space.h). The rest is the best approximation of that order on the
 * reference element, in the mean square. Continuous fields become discontinuous. The mesh stays.
 *
 * The output is the grid with these fields. FieldData's `FIELD_LargestChange` is a proven bound of
 * the change of values anywhere (for several components of the norm of the change); it is infinite
 * where no bound was found. Point and cell arrays with the fields' names hold values of the
 * original fields, and are left out. A plain grid is converted first. Composite data are truncated
 * block by block; in several processes, each of which has parts of blocks, their changes are not
 * reported.
 */

#ifndef vtkHighOrderTruncate_h
#define vtkHighOrderTruncate_h

#include "FieldSelection.h"
#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"

#include <map>    // for changes
#include <string> // for names

class PIXELEXACTFILTERS_EXPORT vtkHighOrderTruncate
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  static vtkHighOrderTruncate* New();
  vtkTypeMacro(vtkHighOrderTruncate, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The order that fields keep, 0 to 32, in each direction; fields of lower order stay. Default 1.
   */
  vtkSetClampMacro(Order, int, 0, 32);
  vtkGetMacro(Order, int);
  ///@}

  ///@{
  /**
   * Whether the change is bounded, which takes longer than the rest. On by default.
   */
  vtkSetMacro(Bounds, bool);
  vtkGetMacro(Bounds, bool);
  vtkBooleanMacro(Bounds, bool);
  ///@}

  ///@{
  /**
   * Names of the fields that are truncated; none: all. A name that the grid lacks is an error.
   */
  void AddField(const std::string& name) { this->Fields.Add(name); }
  void ClearFields() { this->Fields.Clear(); }
  ///@}

protected:
  vtkHighOrderTruncate();
  ~vtkHighOrderTruncate() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderTruncate(const vtkHighOrderTruncate&) = delete;
  void operator=(const vtkHighOrderTruncate&) = delete;

  int Order = 1;
  bool Bounds = true;
  pixelexact::FieldSelection Fields{ this };
  bool InBlocks = false; ///< in a parallel run
  /// Bounds of the changes by the last update on this process, by the names of their arrays.
  std::map<std::string, double> Changes;
};

#endif
