// SPDX-License-Identifier: BSD-3-Clause
#include "BlockInput.h"

#include "VtkMessages.h"

#include <vtkCGNSReader.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace pixelexact
{
namespace
{
/// VTK 9.1 changed the order of two edges in Lagrange hexahedra, but not in its reader of CGNS.
constexpr bool kHasOldEdges = VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION == 1;
constexpr int kCubicPoints = 64;
constexpr int kTenthEdge = 28; ///< of a cubic hexahedron, with two nodes as the next one

void MendCubicHexahedra(vtkUnstructuredGrid& grid)
{
  vtkCellArray& cells = *grid.GetCells();
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    if (grid.GetCellType(cell) != VTK_LAGRANGE_HEXAHEDRON ||
      cells.GetCellSize(cell) != kCubicPoints)
    {
      continue;
    }
    vtkNew<vtkIdList> points;
    cells.GetCellAtId(cell, points);
    vtkIdType* edge = points->GetPointer(kTenthEdge);
    std::swap_ranges(edge, edge + 2, edge + 2);
    cells.ReplaceCellAtId(cell, points);
  }
}

/// Whether there are cells of order above 2 other than cubic hexahedra.
bool HasOtherOrders(vtkUnstructuredGrid& grid)
{
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    const int type = grid.GetCellType(cell);
    const bool isLagrange = type >= VTK_LAGRANGE_CURVE && type <= VTK_LAGRANGE_PYRAMID;
    if (isLagrange && grid.GetCells()->GetCellSize(cell) != kCubicPoints)
    {
      return true;
    }
  }
  return false;
}
/// CGNS's library ends the program where it finds a file damaged. While this lives, such an end
/// says what was read, with the status of work that failed. One at a time.
class ReadGuard
{
public:
  explicit ReadGuard(const std::string& file)
  {
    reading = &file;
    Arm();
  }
  ~ReadGuard() { reading = nullptr; }
  ReadGuard(const ReadGuard&) = delete;
  ReadGuard& operator=(const ReadGuard&) = delete;

  /// Again after libraries were first used: what is registered last runs first, and HDF5 prints at
  /// an end like that.
  static void Arm() { std::atexit(&End); }

private:
  static void End()
  {
    if (reading)
    {
      std::fprintf(stderr,
        "pixelexact: cannot read '%s': the library of CGNS gave up; the file is damaged or cut "
        "short\n",
        reading->c_str());
      std::_Exit(EXIT_FAILURE);
    }
  }

  static inline const std::string* reading = nullptr;
};
} // namespace

InputGrid ReadCgnsFile(const InputRequest& request)
{
  CheckAlone(request.files);
  const std::string& file = request.files[0];
  // Most writers of ADF set the high bit of the first four characters.
  constexpr std::array<std::string_view, 3> kMarks{ kHdf5Mark, "@(#)ADF Database",
    "\xC0\xA8\xA3\xA9"
    "ADF Database" };
  RequireMark(file, kMarks, "CGNS file (HDF5 or ADF)");
  const VtkMessages messages;
  const auto check = [&]
  {
    if (const std::string error = messages.FirstError(); !error.empty())
    {
      CannotRead(file, error);
    }
  };
  vtkNew<vtkCGNSReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetLoadBndPatch(false);
  reader->SetDoublePrecisionMesh(1);
  const ReadGuard guard(file);
  reader->UpdateInformation();
  ReadGuard::Arm();
  check();
  reader->EnableAllBases();
  reader->EnableAllFamilies();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  InputGrid input;
  UpdateToStep(*reader, request, input);
  check();
  input.grid = JoinBlocks(
    *vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0)), file, input.notes);
  if (kHasOldEdges)
  {
    MendCubicHexahedra(*input.grid);
  }
  if (HasOtherOrders(*input.grid))
  {
    input.notes.push_back("'" + file +
      "': of elements of order above 2 only HEXA_64 was checked; the nodes of others stand as "
      "VTK's "
      "reader of CGNS puts them (info --certify shows elements that fold).");
  }
  return input;
}
} // namespace pixelexact
