// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderPack
 * @brief   coefficients as cell arrays, which VTK's filters take along with the cells
 *
 * FieldData holds coefficients without a copy, but it does not follow the cells that filters add,
 * drop and send. The output has the coefficients in cell arrays, named PixelExact.Packed.*. After
 * vtkAppendFilter, vtkExtractCells, vtkThreshold, vtkMergeBlocks, vtkRedistributeDataSetFilter,
 * vtkGhostCellsGenerator, vtkMPIMoveData and .pvtu files each cell still has its own. All classes
 * of PixelExact accept such grids; vtkHighOrderUnpack restores the FieldData. Changes to points,
 * cells or nodal values are detected as without packing. Documentation/parallel.md states what
 * survives which filter.
 *
 * The width of an array is that of the element with the most coefficients; lower orders are padded
 * with zeros. VTK appends arrays of equal width only. Blocks of composite data and the grids of all
 * processes get the same width. For grids that are packed one by one, group them first or set
 * MinimumModes.
 *
 * The input is a grid with coefficients, a plain vtkUnstructuredGrid, which is converted, or
 * composite data of such. Coefficients that do not fit are an error.
 */

#ifndef vtkHighOrderPack_h
#define vtkHighOrderPack_h

#include "PixelExactFiltersModule.h"
#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h" // for the controller

class vtkMultiProcessController;

class PIXELEXACTFILTERS_EXPORT vtkHighOrderPack : public vtkDataObjectAlgorithm
{
public:
  static vtkHighOrderPack* New();
  vtkTypeMacro(vtkHighOrderPack, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Least number of modes per component for which arrays have room: 0, the default, to 35937 (order
   * 32).
   */
  vtkSetClampMacro(MinimumModes, int, 0, 35937);
  vtkGetMacro(MinimumModes, int);
  ///@}

  ///@{
  /**
   * The processes whose grids get arrays of the same width. All of them must then execute. The
   * global controller by default; null: this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkHighOrderPack();
  ~vtkHighOrderPack() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHighOrderPack(const vtkHighOrderPack&) = delete;
  void operator=(const vtkHighOrderPack&) = delete;

  int MinimumModes = 0;
  vtkSmartPointer<vtkMultiProcessController> Controller;
};

#endif
