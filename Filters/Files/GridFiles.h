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

// Reads the single files that make up a grid.

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

/// Adds the essential part of a warning, once. Warnings about keys of vtkExodusIIReader, which
/// ParaView saves with its data, are left out: they do not concern mesh or fields.
PIXELEXACTFILTERS_EXPORT void AddWarning(std::vector<std::string>& lines, std::string_view text);

/// Adds a line unless it is already there.
PIXELEXACTFILTERS_EXPORT void AddOnce(std::vector<std::string>& lines, const std::string& line);

/// Lists the .vtu, .vtk and .vtkhdf files of all parts, also those that .pvtu files name. Surfaces
/// (.vtp) in a collection with a volume are noted. Throws Error for other files, and where there is
/// none.
std::vector<GridPart> ListFiles(
  const std::vector<GridPart>& parts, std::vector<std::string>& notes);

/// Reads files of unstructured grids, in VTK's XML, HDF or legacy format; the content decides, not
/// the suffix. VTK's warnings become notes; a warning for several files is noted for the first
/// one.
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

/// The beginning of errors about a file.
[[nodiscard]] std::string CannotRead(const GridPart& part);
} // namespace pixelexact
#endif
