// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNektarReader
 * @brief   reads Nektar++ sessions and field files
 *
 * The session (SetFileName) holds the geometry of three dimensions or two (files.md): XML, plain
 * or compressed, or the name of an HDF5 file beside it (`.nekg`), which may also be named itself.
 * Further session files (AddSessionFileName) may hold the rest, or other parts of the mesh; a
 * folder (`NAME_xml`, as parallel runs write it) stands for the parts in it. Field files
 * (AddFieldFileName: `.fld`, `.chk`, `.rst`, XML or HDF5; a folder for those of parallel runs)
 * become fields of the names in them. Several field files are time steps, ordered by the time in
 * their metadata, or where one has none by the order given and numbered from 0.
 * Module/Documentation/files.md says what is read and what is not.
 */

#ifndef vtkNektarReader_h
#define vtkNektarReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderFileReader.h"

#include <memory>

// As vtkWrapHierarchy of VTK 9.1 reads it.
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
   * Further files of the session.
   */
  void AddSessionFileName(const char* name);
  void ClearSessionFileNames();
  ///@}

  ///@{
  /**
   * Field files, one per time step.
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

  /// Of the mesh, for further time steps; none: there is one step.
  std::unique_ptr<pixelexact::nektar::SessionMesh> Outline;
  std::vector<std::string> Sessions;
  std::vector<std::string> FieldFiles;
  std::vector<int> FileOfStep;
};

#endif
