// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderGridAlgorithm
 * @brief   superclass of algorithms that make a vtkHighOrderGrid
 *
 * It makes the output, and keeps what was noticed on the way.
 */

#ifndef vtkHighOrderGridAlgorithm_h
#define vtkHighOrderGridAlgorithm_h

#include "PixelExactFiltersModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for diagnostics
#include <vector> // for diagnostics

class vtkHighOrderGrid;

class PIXELEXACTFILTERS_EXPORT vtkHighOrderGridAlgorithm : public vtkUnstructuredGridAlgorithm
{
public:
  vtkTypeMacro(vtkHighOrderGridAlgorithm, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Diagnostics of the last execution: lines about suspicious data. They were also issued as
   * warnings.
   */
  int GetNumberOfDiagnostics();
  std::string GetDiagnostic(int index);
  ///@}

  vtkHighOrderGrid* GetHighOrderOutput();

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkHighOrderGridAlgorithm();
  ~vtkHighOrderGridAlgorithm() override;

  /// Adds a diagnostic, and warns.
  void Report(const std::string& line);
  void ClearDiagnostics() { this->Diagnostics.clear(); }

private:
  vtkHighOrderGridAlgorithm(const vtkHighOrderGridAlgorithm&) = delete;
  void operator=(const vtkHighOrderGridAlgorithm&) = delete;

  std::vector<std::string> Diagnostics;
};

#endif
