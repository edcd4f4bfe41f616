// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridFiles_h
#define GridFiles_h

#include "Files/TimeSeries.h"
#include "PixelExactFiltersModule.h"

#include "vtkCommand.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

class vtkXMLReader;

// The single files of which grids are put together.

namespace pixelexact
{
/// Keeps what a reader reports instead of having it printed.
class ReaderMessages : public vtkCommand
{
public:
  static ReaderMessages* New() { return new ReaderMessages; }
  void Execute(vtkObject* caller, unsigned long event, void* data) override;
  void Watch(vtkXMLReader* reader);

  std::string error;                 ///< the first one; empty: none
  std::vector<std::string> warnings; ///< each once
};

/// "ERROR: In x.cxx, line 7\nvtkReader (0x5581): Cannot read." becomes "Cannot read", on one line.
PIXELEXACTFILTERS_EXPORT std::string MessageEssence(std::string_view text);

/// Adds the essence of a warning, once. Left out are keys of vtkExodusIIReader, which ParaView
/// saves with what it has read by it: they say nothing of mesh or fields.
PIXELEXACTFILTERS_EXPORT void AddWarning(std::vector<std::string>& lines, std::string_view text);

/// Adds a line that is not there yet.
PIXELEXACTFILTERS_EXPORT void AddOnce(std::vector<std::string>& lines, const std::string& line);

/// The .vtu and .vtk files of all parts, also those that .pvtu files name. Surfaces (.vtp) that a
/// collection lists beside the volume are noted. Throws Error for other files, and where there is
/// none.
std::vector<GridPart> ListFiles(
  const std::vector<GridPart>& parts, std::vector<std::string>& notes);

/// Reads files of unstructured grids, VTK's XML format or its legacy one: the content decides, not
/// the suffix. VTK's warnings become notes; what several files have alike is said of the first one.
class GridFileReader
{
public:
  explicit GridFileReader(std::vector<std::string>& notes)
    : Notes(notes)
  {
  }
  /// The pieces of a file that have cells, at least one grid; one grid where the file carries
  /// coefficients. Throws Error, naming the file.
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> Read(const GridPart& part);

private:
  std::vector<std::string>& Notes;
  std::set<std::string> Said;
};

/// How errors about a file begin.
[[nodiscard]] std::string CannotRead(const GridPart& part);
} // namespace pixelexact
#endif
