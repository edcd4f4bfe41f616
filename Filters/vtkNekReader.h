// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNekReader
 * @brief   reads fields of Nek5000, nekRS and neko
 *
 * The file (SetFileName): `x.nek5000`, which lists the files of a run's steps, or the file of a
 * step (`x0.f00001`), with further steps (AddStepFileName). Files hold values at the
 * Gauss-Lobatto-Legendre nodes of hexahedra, or of quadrilaterals in the plane, in single or double
 * precision and either byte order. Of a step in several files all are read. A step without a mesh
 * has that of the last step before it with one, or of the first after it. Elements are in the order
 * of their numbers. Fields are `velocity`, `pressure`, `temperature`, `s1`, `s2`, ...
 * Module/Documentation/files.md says what is refused.
 */

#ifndef vtkNekReader_h
#define vtkNekReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderFileReader.h"

#include <memory> // for the steps
#include <string> // for names
#include <vector> // for names

// The namespaces are nested so that vtkWrapHierarchy of VTK 9.1 can parse them.
// NOLINTNEXTLINE(modernize-concat-nested-namespaces)
namespace pixelexact
{
namespace nek5000
{
class Series;
}
} // namespace pixelexact

class PIXELEXACTFILTERS_EXPORT vtkNekReader : public vtkHighOrderFileReader
{
public:
  static vtkNekReader* New();
  vtkTypeMacro(vtkNekReader, vtkHighOrderFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Files of further steps, where the file is that of a step. They are ordered by their times.
   */
  void AddStepFileName(const char* name);
  void ClearStepFileNames();
  ///@}

  /**
   * The names of the fields, after UpdateInformation.
   */
  std::vector<std::string> GetFieldNames();

protected:
  vtkNekReader();
  ~vtkNekReader() override;

  pixelexact::SolverModel ReadModel(int step, bool wantMesh) override;
  bool IsHead(const std::string& head) override;
  std::vector<double> ReadTimes() override;
  int StepOfMesh(int step) override;

private:
  vtkNekReader(const vtkNekReader&) = delete;
  void operator=(const vtkNekReader&) = delete;

  std::vector<std::string> StepFiles; ///< of further steps
  std::unique_ptr<pixelexact::nek5000::Series> Series;
};

#endif
