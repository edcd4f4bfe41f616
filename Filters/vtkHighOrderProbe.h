// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderProbe
 * @brief   exact values of high-order fields at given points
 *
 * Port 0 takes the points (any data set), port 1 the grid: one that carries high-order
 * coefficients, or a plain vtkUnstructuredGrid, which is converted. The output has the structure of
 * port 0 and the point arrays <field>            value; NaN where the point is not inside
 *   <field>_Gradient   on request, 3 per component: d/dx, d/dy, d/dz
 *   Xi                 reference coordinates in the element; NaN where not inside
 *   Element            number of the cell in the source; -1 outside
 *   Verdict            0 outside, 1 inside, 2 unknown: could not be decided in the budget. Element
 * is then one that may hold the point Residual           last correction of Newton's iteration, in
 * xi
 */

#ifndef vtkHighOrderProbe_h
#define vtkHighOrderProbe_h

#include "PixelExactFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"

#include <memory> // for the model
#include <string> // for names
#include <vector> // for names

class vtkUnstructuredGrid;

namespace pixelexact
{
class ModelSource;
}

class PIXELEXACTFILTERS_EXPORT vtkHighOrderProbe : public vtkPassInputTypeAlgorithm
{
public:
  static vtkHighOrderProbe* New();
  vtkTypeMacro(vtkHighOrderProbe, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The grid: port 1.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkUnstructuredGrid* grid);
  ///@}

  ///@{
  /**
   * Names of the fields to evaluate; none: all. A name that the grid lacks is an error.
   */
  void AddField(const std::string& name);
  void ClearFields();
  ///@}

  ///@{
  /**
   * Whether to add gradients. Off by default.
   */
  vtkSetMacro(ComputeGradients, bool);
  vtkGetMacro(ComputeGradients, bool);
  vtkBooleanMacro(ComputeGradients, bool);
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

private:
  vtkHighOrderProbe(const vtkHighOrderProbe&) = delete;
  void operator=(const vtkHighOrderProbe&) = delete;

  std::vector<std::string> Fields;
  bool ComputeGradients = false;
  std::unique_ptr<pixelexact::ModelSource> Source;
};

#endif
