// SPDX-License-Identifier: BSD-3-Clause
#include "ExodusSides.h"

#include "Core/Base/Counted.h"
#include "SourceFaces.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <limits>
#include <unordered_map>

namespace pixelexact
{
namespace
{
/// Of each side in Exodus' order its face, as FacesOf(shape) counts. Corners stand in the file as
/// in VTK's cells, which CellBasis.h places in xi.
std::vector<int> FacesOfSides(int cellType)
{
  switch (cellType)
  {
    case VTK_HEXAHEDRON:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
      return { 3, 2, 4, 1, 0, 5 };
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
      return { 3, 2, 1, 0 };
    case VTK_WEDGE:
    case VTK_QUADRATIC_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
      return { 0, 2, 1, 4, 3 };
    case VTK_PYRAMID:
    case VTK_QUADRATIC_PYRAMID:
      return { 3, 2, 4, 1, 0 };
    case VTK_TRIANGLE:
    case VTK_QUADRATIC_TRIANGLE:
      return { 0, 2, 1 };
    case VTK_QUAD:
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
      return { 3, 2, 4, 1 };
    default:
      return {};
  }
}
} // namespace

void AddSideSets(const std::vector<ExodusFile::SideSet>& sets, vtkUnstructuredGrid& grid,
  std::vector<std::string>& notes)
{
  vtkDataArray* numbers = grid.GetCellData()->GetArray(kExodusElement);
  if (sets.empty() || numbers == nullptr)
  {
    return;
  }
  std::unordered_map<std::int64_t, vtkIdType> cellOf;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    cellOf.emplace(static_cast<std::int64_t>(numbers->GetComponent(cell, 0)), cell);
  }
  std::vector<AttributedFace> faces;
  std::size_t others = 0;
  for (const ExodusFile::SideSet& set : sets)
  {
    for (std::size_t i = 0; i < set.elements.size(); ++i)
    {
      const auto cell = cellOf.find(set.elements[i]);
      const std::vector<int> faceOf =
        cell == cellOf.end() ? std::vector<int>() : FacesOfSides(grid.GetCellType(cell->second));
      const std::int64_t side = set.sides[i];
      if (side < 1 || side > static_cast<std::int64_t>(faceOf.size()) ||
        set.id > std::numeric_limits<std::int32_t>::max())
      {
        ++others;
        continue;
      }
      faces.push_back(
        { { static_cast<std::int32_t>(cell->second), faceOf[static_cast<std::size_t>(side - 1)] },
          static_cast<std::int32_t>(set.id) });
    }
  }
  AddSourceFaces(faces, &grid);
  if (others > 0)
  {
    notes.push_back(Counted(others, "side") +
      " of side sets are no faces of solids or plane elements and were left out.");
  }
}
} // namespace pixelexact
