// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlexiReader
 * @brief   reads states of FLEXI and meshes of HOPR
 *
 * The file (SetFileName): a state (`x_State_*.h5`), whose mesh is found beside it under the name
 * that it states, or a mesh (`x_mesh.h5`); with further states (AddStateFileName), which are time
 * steps. Elements are curved hexahedra. Fields are discontinuous: the variables of DG_Solution and
 * of FieldData at Gauss-Legendre or Gauss-Lobatto-Legendre nodes, and those of ElemData, constant
 * in elements. Boundary conditions are attributes of faces, zones of elements.
 * Module/Documentation/files.md states what is refused. Requires the HDF5 library.
 */

#ifndef vtkFlexiReader_h
#define vtkFlexiReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderFileReader.h"

#include <memory> // for the steps
#include <string> // for names
#include <vector> // for names

// The namespaces are nested so that vtkWrapHierarchy of VTK 9.1 can parse them.
// NOLINTNEXTLINE(modernize-concat-nested-namespaces)
namespace pixelexact
{
namespace flexi
{
class Series;
}
} // namespace pixelexact

class PIXELEXACTFILTERS_EXPORT vtkFlexiReader : public vtkHighOrderFileReader
{
public:
  static vtkFlexiReader* New();
  vtkTypeMacro(vtkFlexiReader, vtkHighOrderFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * States. They are ordered by their times.
   */
  void AddStateFileName(const char* name);
  void ClearStateFileNames();
  ///@}

  /**
   * The names of the variables of DG_Solution, after UpdateInformation.
   */
  std::vector<std::string> GetFieldNames();

  /**
   * Whether a file is a mesh of HOPR or a state of FLEXI, by its data sets.
   */
  int CanReadFile(const char* name) override;

protected:
  vtkFlexiReader();
  ~vtkFlexiReader() override;

  pixelexact::SolverModel ReadModel(int step, bool wantMesh) override;
  bool IsHead(const std::string& head) override;
  std::vector<double> ReadTimes() override;
  int StepOfMesh(int step) override;

private:
  vtkFlexiReader(const vtkFlexiReader&) = delete;
  void operator=(const vtkFlexiReader&) = delete;

  std::vector<std::string> StateFiles;
  std::unique_ptr<pixelexact::flexi::Series> Series;
};

#endif
