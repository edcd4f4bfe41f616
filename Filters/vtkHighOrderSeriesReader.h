// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSeriesReader
 * @brief   reads time series of unstructured grids, in one or several pieces per step
 *
 * Reads a collection (.pvd: steps with times and parts), a .vtu or .pvtu file, or several of them,
 * one per time step at the times 0, 1, 2... Follow it by vtkUnstructuredGridToHighOrderGrid: from
 * one time step to the next that keeps the mesh, and with it the locators of those behind, where
 * points and cells stay the same.
 *
 * The steps are the pipeline's TIME_STEPS; the one nearest below the time asked for is read, the
 * first one without such a request. A single file has none.
 *
 * Parts of a step are put together without merging points. Ghost cells that another part holds too,
 * parts without volume cells, and arrays that not all parts have alike are left out, the latter two
 * with a warning. Coefficients that a file carries are read as they are where it is the only part,
 * and put together where all parts carry those of a solver; those of several parts that were made
 * from nodal values are dropped, to be made again.
 *
 * Asked for a piece of several (UPDATE_PIECE_NUMBER) it gives that piece: of several parts some
 * that follow each other, of a single file, which is read whole, a
 * share of the cells. CellData PixelExactSourceCell then has the cells' numbers in the whole, as
 * vtkHighOrderFileReader says; the conversion keeps them.
 *
 * Errors go to vtkErrorMacro, with the file; the output is then empty. Modified() makes it read the
 * files anew.
 */

#ifndef vtkHighOrderSeriesReader_h
#define vtkHighOrderSeriesReader_h

#include "PixelExactFiltersModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for the steps
#include <string> // for names
#include <vector> // for names

class PIXELEXACTFILTERS_EXPORT vtkHighOrderSeriesReader : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkHighOrderSeriesReader* New();
  vtkTypeMacro(vtkHighOrderSeriesReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The only file, in the place of all others. GetFileName: the first one, empty where there is
   * none.
   */
  void SetFileName(const char* name);
  const char* GetFileName();
  ///@}

  ///@{
  /**
   * The file of one more time step: .vtu or .pvtu; a .pvd file is to be the only one.
   */
  void AddFileName(const char* name);
  void ClearFileNames();
  int GetNumberOfFileNames();
  ///@}

  ///@{
  /**
   * Of the last execution: lines about what was left out and what VTK's reader warned of.
   */
  int GetNumberOfDiagnostics();
  std::string GetDiagnostic(int index);
  ///@}

protected:
  vtkHighOrderSeriesReader();
  ~vtkHighOrderSeriesReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHighOrderSeriesReader(const vtkHighOrderSeriesReader&) = delete;
  void operator=(const vtkHighOrderSeriesReader&) = delete;

  struct Internals;

  std::vector<std::string> FileNames;
  std::vector<std::string> Diagnostics;
  std::unique_ptr<Internals> Series;
};

#endif
