// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockInput.h"
#include "Input/CgnsSides.h"

#include "Base/VtkMessages.h"
#include "Formats/ApartProcess.h"

#include <vtkCGNSReader.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace pixelexact
{
namespace
{
/// VTK 9.1 changed the order of two edges in Lagrange hexahedra, but its CGNS reader uses the new
/// order only since 9.5. Before 9.5 it also orders the nodes inside a wedge's third quadrilateral
/// from the third corner to the first, opposite to VTK's wedges.
constexpr bool kHasOldOrder = VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 5;
constexpr int kCubicPoints = 64;
constexpr int kCubicTetrahedronPoints = 20;
constexpr int kTenthEdge = 28; ///< of a cubic hexahedron, with two nodes as the next one
constexpr int kCubicWedgePoints = 40;
constexpr int kThirdSquare = 34;   ///< of a cubic wedge, with four nodes
constexpr int kPyramidPoints = 14; ///< of PYRA_14, which VTK's reader makes a cell of 13 nodes

/// Swaps `count` nodes from `first` on with the next `count`, in all cells of a type.
void ExchangeNodes(vtkUnstructuredGrid& grid, int type, vtkIdType size, int first, int count)
{
  vtkCellArray& cells = *grid.GetCells();
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    if (grid.GetCellType(cell) != type || cells.GetCellSize(cell) != size)
    {
      continue;
    }
    vtkNew<vtkIdList> points;
    cells.GetCellAtId(cell, points);
    vtkIdType* nodes = points->GetPointer(first);
    std::swap_ranges(nodes, nodes + count, nodes + count);
    cells.ReplaceCellAtId(cell, points);
  }
}

void MendCubicCells(vtkUnstructuredGrid& grid)
{
  if (!kHasOldOrder)
  {
    return;
  }
  ExchangeNodes(grid, VTK_LAGRANGE_HEXAHEDRON, kCubicPoints, kTenthEdge, 2);
  for (const int first : { kThirdSquare, kThirdSquare + 2 })
  {
    ExchangeNodes(grid, VTK_LAGRANGE_WEDGE, kCubicWedgePoints, first, 1);
  }
}

/// VTK's reader turns unknown elements into empty cells, and PYRA_14 into invalid ones.
void RefuseUnknownElements(
  vtkUnstructuredGrid& grid, const std::vector<CgnsZone>& zones, const std::string& file)
{
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    if (grid.GetCellType(cell) == VTK_QUADRATIC_PYRAMID &&
      grid.GetCells()->GetCellSize(cell) == kPyramidPoints)
    {
      CannotRead(file,
        "it has elements PYRA_14, of which the format defines the nodes, but no functions; write "
        "PYRA_5, or elements of other shapes, such as TETRA_10, PENTA_18 and HEXA_27");
    }
    if (grid.GetCellType(cell) == VTK_EMPTY_CELL)
    {
      std::set<std::string> types;
      for (const CgnsZone& zone : zones)
      {
        types.insert(zone.elements.begin(), zone.elements.end());
      }
      std::string list;
      for (const std::string& type : types)
      {
        list += (list.empty() ? "" : ", ") + type;
      }
      CannotRead(file,
        "VTK's reader does not know all of its elements (" + list +
          "); write complete ones of orders 1 to 3, such as TETRA_20, PENTA_40 and HEXA_64");
    }
  }
}

/// Whether there are cells of order above 2 other than those that were checked.
bool HasOtherOrders(vtkUnstructuredGrid& grid)
{
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    const int type = grid.GetCellType(cell);
    const vtkIdType points = grid.GetCells()->GetCellSize(cell);
    const bool isLagrange = type >= VTK_LAGRANGE_CURVE && type <= VTK_LAGRANGE_PYRAMID;
    const bool isChecked = (type == VTK_LAGRANGE_HEXAHEDRON && points == kCubicPoints) ||
      (type == VTK_LAGRANGE_WEDGE && points == kCubicWedgePoints) ||
      (type == VTK_LAGRANGE_TETRAHEDRON && points == kCubicTetrahedronPoints);
    if (isLagrange && !isChecked)
    {
      return true;
    }
  }
  return false;
}

InputGrid ReadHere(const InputRequest& request)
{
  const std::string& file = request.files[0];
  const std::vector<CgnsZone> zones = ReadCgnsZones(file);
  const VtkMessages messages;
  const auto check = [&]
  {
    if (const std::string error = messages.FirstError(); !error.empty())
    {
      CannotRead(file,
        "VTK's reader says: " + error +
          "; write the file again with its solver or the CGNS library, or in another format");
    }
  };
  vtkNew<vtkCGNSReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetLoadBndPatch(false);
  reader->SetDoublePrecisionMesh(std::ranges::all_of(zones, &CgnsZone::isSingle) ? 0 : 1);
  reader->SetController(nullptr); // every process reads the file
  reader->UpdateInformation();
  check();
  reader->EnableAllBases();
  reader->EnableAllFamilies();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  InputGrid input;
  UpdateToStep(*reader, request, input);
  check();
  if (request.timesAlone)
  {
    return input;
  }
  auto* read = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  input.grid = JoinBlocks(*read, file, input.notes);
  AddBoundaryConditions(zones, *read, *input.grid, input.notes);
  RefuseUnknownElements(*input.grid, zones, file);
  MendCubicCells(*input.grid);
  if (std::ranges::any_of(zones, &CgnsZone::isSingle) &&
    !std::ranges::all_of(zones, &CgnsZone::isSingle))
  {
    input.notes.push_back("'" + file +
      "': some zones have coordinates in single precision; the rounding of these is not counted as "
      "an error of the mesh.");
  }
  if (HasOtherOrders(*input.grid))
  {
    input.notes.push_back("'" + file +
      "': of elements of order above 2 TETRA_20, PENTA_40 and HEXA_64 were checked; the nodes of "
      "others "
      "stand as VTK's reader of CGNS puts them (info --certify shows elements that fold).");
  }
  return input;
}
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
  RunApart(LimitsForFile(std::filesystem::file_size(file)), "the CGNS library or VTK's reader",
    [&] { ReadHere(request); });
  return ReadHere(request);
}
} // namespace pixelexact
