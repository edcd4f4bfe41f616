// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryArrays.h"

#include "Core/Base/Error.h"
#include "Core/Shape/ShapeFace.h"

#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
[[noreturn]] void Fail(std::size_t entry, const std::string& what)
{
  throw InvalidData("arrays '" + std::string(kBoundaryPrefix) + "*', entry " +
    std::to_string(entry) + ", name " + what + ", which is not there; read the source file again.");
}
} // namespace

std::vector<AttributedFace> ReadBoundary(
  vtkUnstructuredGrid* grid, const Mesh& mesh, const CellElements& cells, vtkIdType elements)
{
  const std::string prefix = kBoundaryPrefix;
  const auto has = [&](const char* name)
  { return grid->GetFieldData()->HasArray((prefix + name).c_str()) != 0; };
  std::vector<AttributedFace> boundary;
  if (!has("Element") && !has("Face") && !has("Attribute"))
  {
    return boundary;
  }
  ArrayKeeper keeper;
  const auto element = ViewArray<std::int64_t>(grid, prefix + "Element", 1, -1, keeper);
  const auto entries = static_cast<vtkIdType>(element.size());
  const auto face = ViewArray<std::int32_t>(grid, prefix + "Face", 1, entries, keeper);
  const auto attribute = ViewArray<std::int32_t>(grid, prefix + "Attribute", 1, entries, keeper);
  const auto cellOf = cells.CellOfElements(elements);
  for (std::size_t i = 0; i < element.size(); ++i)
  {
    if (element[i] < 0 || element[i] >= elements)
    {
      Fail(i, "element " + std::to_string(element[i]) + " of " + std::to_string(elements));
    }
    const std::int32_t cell = cellOf[element[i]];
    if (cell < 0)
    {
      continue;
    }
    const auto faces = static_cast<std::int32_t>(FacesOf(mesh.ShapeOf(cell)).size());
    if (face[i] < 0 || face[i] >= faces)
    {
      Fail(i, "face " + std::to_string(face[i]) + " of a " + Name(mesh.ShapeOf(cell)));
    }
    boundary.push_back({ { cell, face[i] }, attribute[i] });
  }
  std::ranges::sort(boundary);
  boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
  return boundary;
}
} // namespace pixelexact
