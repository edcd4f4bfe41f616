// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridFiles_h
#define GridFiles_h

#include "Files/TimeSeries.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <set>
#include <string>
#include <vector>

// The single files of which grids are put together.
namespace pixelexact
{
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
