// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ExodusSides.h"

#include "Input/CellSides.h"

#include "Conversion/SourceFaces.h"
#include "Core/Base/Counted.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <limits>
#include <unordered_map>

namespace pixelexact
{
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
      const std::span<const CellSide> sides = cell == cellOf.end()
        ? std::span<const CellSide>()
        : SidesOf(grid.GetCellType(cell->second));
      const std::int64_t side = set.sides[i];
      if (side < 1 || side > std::ssize(sides) || set.id > std::numeric_limits<std::int32_t>::max())
      {
        ++others;
        continue;
      }
      faces.push_back({ { static_cast<std::int32_t>(cell->second),
                          sides[static_cast<std::size_t>(side - 1)].face },
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
