// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNektarReader
 * @brief   reads Nektar++ sessions and field files
 *
 * The session (SetFileName) holds a geometry of two or three dimensions (files.md): XML, plain or
 * compressed, or the name of an HDF5 file beside it (`.nekg`), which may also be given itself.
 * Further session files (AddSessionFileName) may hold other sections or other parts of the mesh. A
 * folder (`NAME_xml`, as parallel runs write it) stands for the parts in it. Field files
 * (AddFieldFileName: `.fld`, `.chk`, `.rst`, XML or HDF5; a folder for parallel runs) become fields
 * with the names in them. Several field files are time steps, ordered by the time in their metadata
 * or, where one has none, in the given order and numbered from 0. Module/Documentation/files.md
 * lists what is read and what is not.
 */

#ifndef vtkNektarReader_h
#define vtkNektarReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderFileReader.h"

#include <memory>

// The namespaces are nested so that vtkWrapHierarchy of VTK 9.1 can parse them.
// NOLINTNEXTLINE(modernize-concat-nested-namespaces)
namespace pixelexact
{
namespace nektar
{
struct SessionMesh;
}
} // namespace pixelexact

class PIXELEXACTFILTERS_EXPORT vtkNektarReader : public vtkHighOrderFileReader
{
public:
  static vtkNektarReader* New();
  vtkTypeMacro(vtkNektarReader, vtkHighOrderFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Adds further files of the session.
   */
  void AddSessionFileName(const char* name);
  void ClearSessionFileNames();
  ///@}

  ///@{
  /**
   * Adds field files, one per time step.
   */
  void AddFieldFileName(const char* name);
  void ClearFieldFileNames();
  ///@}

protected:
  vtkNektarReader();
  ~vtkNektarReader() override;

  pixelexact::SolverModel ReadModel(int step, bool wantMesh) override;
  bool IsHead(const std::string& head) override;
  std::vector<double> ReadTimes() override;

private:
  vtkNektarReader(const vtkNektarReader&) = delete;
  void operator=(const vtkNektarReader&) = delete;

  pixelexact::nektar::SessionMesh ReadSession();

  /// Kept for further time steps; null where there is one step.
  std::unique_ptr<pixelexact::nektar::SessionMesh> Outline;
  std::vector<std::string> Sessions;
  std::vector<std::string> FieldFiles;
  std::vector<int> FileOfStep;
};

#endif
