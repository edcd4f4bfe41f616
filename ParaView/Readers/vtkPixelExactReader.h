// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactReader
 * @brief   what opens a file in ParaView: a reader with what else it needs, and a choice of fields
 *
 * Subclasses find the files that belong to the one that was opened and set up the readers and
 * filters that make the grid. The output is that grid, a vtkUnstructuredGrid with the fields that
 * are chosen. Times are those of the readers.
 */

#ifndef vtkPixelExactReader_h
#define vtkPixelExactReader_h

#include "PixelExactParaViewReadersModule.h"
#include "vtkNew.h"       // for the choice of fields
#include "vtkTimeStamp.h" // for when files were looked for
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for names
#include <vector> // for names

class vtkDataArraySelection;

class PIXELEXACTPARAVIEWREADERS_EXPORT vtkPixelExactReader : public vtkUnstructuredGridAlgorithm
{
public:
  vtkTypeMacro(vtkPixelExactReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The files that were opened.
   */
  void SetFileName(const char* name);
  void AddFileName(const char* name);
  void RemoveAllFileNames();
  ///@}

  ///@{
  /**
   * Those of vtkHighOrderFileReader, for files that one of its subclasses reads.
   */
  vtkSetMacro(Cells, int);
  vtkGetMacro(Cells, int);
  vtkSetMacro(MaximumNumberOfNodes, vtkIdType);
  vtkGetMacro(MaximumNumberOfNodes, vtkIdType);
  ///@}

  /**
   * Whether a file's content is of the reader's kind (1) or not (0). ParaView calls all readers of
   * a suffix, and offers those that return 1.
   */
  virtual int CanReadFile(const char* name) = 0;

  /**
   * The selection of the output's fields, known before reading or found by it.
   */
  vtkDataArraySelection* GetFieldSelection();

  /**
   * The selection's modification time counts as well.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkPixelExactReader();
  ~vtkPixelExactReader() override;

  /**
   * Returns the source of the grid. Must be called after Prepare.
   */
  virtual vtkAlgorithm* GetSource() = 0;

  /**
   * Sets up what makes the grid, after anything was changed, and offers fields. Throws
   * pixelexact::Error.
   */
  virtual void Prepare() = 0;

  /**
   * Adds a field to the selection. `chosen` is its state until the user changes it.
   */
  void Offer(const std::string& field, bool chosen);
  bool IsChosen(const std::string& field);

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<std::string> FileNames;

private:
  vtkPixelExactReader(const vtkPixelExactReader&) = delete;
  void operator=(const vtkPixelExactReader&) = delete;

  int Cells = 0;
  vtkIdType MaximumNumberOfNodes = 4'000'000;
  vtkNew<vtkDataArraySelection> Fields;
  vtkTimeStamp PrepareTime;
};

#endif
