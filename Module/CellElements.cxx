// SPDX-License-Identifier: BSD-3-Clause
#include "CellElements.h"

#include "ConversionLoss.h"
#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include "vtkCellData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

namespace pixelexact
{
namespace
{
[[noreturn]] void Fail(vtkUnstructuredGrid* grid, std::size_t cell, const std::string& problem)
{
  throw StaleData("cell " + std::to_string(cell) + " " + problem + RemedyOf(grid));
}
} // namespace

CellElements::CellElements(vtkUnstructuredGrid* grid, vtkIdType elements)
  : Element(grid->GetNumberOfCells())
{
  if (grid->GetCellData()->HasArray(kElementIds))
  {
    ArrayKeeper keeper;
    std::ranges::copy(ViewElementIds(grid, keeper), Element.begin());
  }
  else if (grid->GetNumberOfCells() == elements)
  {
    std::iota(Element.begin(), Element.end(), 0);
  }
  else
  {
    throw StaleData(std::string("the grid has ") + Counted(grid->GetNumberOfCells(), "cell") +
      " and coefficients of " + Counted(elements, "element") + ", but no cell array '" +
      kElementIds + "' that maps cells to elements; pass that array on" + RemedyOf(grid));
  }
  std::vector<bool> seen(elements, false);
  for (std::size_t cell = 0; cell < Element.size(); ++cell)
  {
    const auto element = Element[cell];
    if (element < 0 || element >= elements)
    {
      Fail(
        grid, cell, "names element " + std::to_string(element) + " of " + std::to_string(elements));
    }
    if (seen[element])
    {
      Fail(grid, cell,
        "and another one both claim element " + std::to_string(element) +
          ": cells were cut in pieces (Clip), or data sets put together (Append); select whole "
          "cells instead (ExtractCells, Threshold)");
    }
    seen[element] = true;
  }
  Whole = static_cast<vtkIdType>(Element.size()) == elements && std::ranges::is_sorted(Element);
}

std::vector<std::int32_t> CellElements::CellOfElements(vtkIdType elements) const
{
  std::vector<std::int32_t> cells(elements, -1);
  for (std::size_t cell = 0; cell < Element.size(); ++cell)
  {
    cells[Element[cell]] = static_cast<std::int32_t>(cell);
  }
  return cells;
}

std::size_t CellElements::FirstMisfit(const std::function<std::vector<std::int64_t>(Hash)>& now,
  std::span<const std::int64_t> then) const
{
  const auto firstOther = [&](Hash hash)
  {
    const auto prints = now(hash);
    std::size_t cell = 0;
    while (cell < Element.size() && prints[cell] == then[Element[cell]])
    {
      ++cell;
    }
    return cell;
  };
  const std::size_t cell = firstOther(Hash::XXH3);
  return cell < Element.size() && firstOther(Hash::First) < Element.size() ? cell : Element.size();
}

bool CellElements::Fit(const std::function<std::vector<std::int64_t>(Hash)>& now,
  std::span<const std::int64_t> then) const
{
  return FirstMisfit(now, then) == Element.size();
}

void CellElements::Compare(vtkUnstructuredGrid* grid,
  const std::function<std::vector<std::int64_t>(Hash)>& now, std::span<const std::int64_t> then,
  const std::string& problem) const
{
  if (const std::size_t cell = FirstMisfit(now, then); cell < Element.size())
  {
    Fail(grid, cell, problem);
  }
}

Expansion ViewStorage::Assemble(ExpansionView view, const CellElements& cells, int components)
{
  Expansion expansion;
  expansion.spaces = spaces.emplace_back(std::move(view.spaces));
  expansion.spaceOf = cells.Select(view.spaceOf, ints);
  expansion.offset = cells.Select(view.offset, longs);
  expansion.coefficients = view.coefficients;
  expansion.components = components;
  return expansion;
}
} // namespace pixelexact
