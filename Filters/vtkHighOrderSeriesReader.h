// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderSeriesReader
 * @brief   reads time series of unstructured grids, in one or several pieces per step
 *
 * Reads a collection (.pvd: steps with times and parts), a .vtu or .pvtu file, or several of them,
 * one per time step at the times 0, 1, 2..., or .vtkhdf files, which may have steps of their own.
 * vtkUnstructuredGridToHighOrderGrid should follow it:
 * where points and cells stay the same in the next time step, it keeps the mesh and its locators.
 *
 * The steps are the pipeline's TIME_STEPS. The one nearest below the requested time is read, the
 * first one without a request. A single .vtu or .pvtu file has no steps.
 *
 * Parts of a step are appended without merging points. Ghost cells that another part also holds,
 * parts without volume cells, and arrays that not all parts have are left out, the latter two with
 * a warning. Coefficients are kept where the file is the only part, and joined where all parts have
 * those of a solver. Coefficients of several parts that were converted from nodal values are
 * dropped and converted again.
 *
 * If a piece of several is requested (UPDATE_PIECE_NUMBER), the output is that piece: consecutive
 * ones of several parts, or a share of the cells of a single file, which is read whole. CellData
 * PixelExactSourceCell then has the cells' numbers in the whole, as in vtkHighOrderFileReader; the
 * conversion keeps them.
 *
 * Errors go to vtkErrorMacro, with the file; the output is then empty. After Modified() the files
 * are read again.
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
   * The only file, which replaces all others. GetFileName returns the first file, empty where there
   * is none.
   */
  void SetFileName(const char* name);
  const char* GetFileName();
  ///@}

  ///@{
  /**
   * Adds the file of a further time step: .vtu, .pvtu or .vtkhdf. A .pvd file must be the only one.
   */
  void AddFileName(const char* name);
  void ClearFileNames();
  int GetNumberOfFileNames();
  ///@}

  ///@{
  /**
   * Whether parts with surface elements are kept in place of those with volumes. Off by default.
   * The converter needs the same choice (vtkUnstructuredGridToHighOrderGrid::SetSurfaceElements).
   */
  vtkSetMacro(SurfaceElements, bool);
  vtkGetMacro(SurfaceElements, bool);
  vtkBooleanMacro(SurfaceElements, bool);
  ///@}

  ///@{
  /**
   * Notes of the last execution: parts and arrays that were left out, and warnings of VTK's reader.
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
  bool SurfaceElements = false;
  std::unique_ptr<Internals> Series;
};

#endif
