// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/MeshFile.h"

#include "Formats/MFEM/Elements/GeometryTable.h"

#include <array>

namespace pixelexact::mfem
{
bool IsOfDimension(Geometry geometry, int dimension)
{
  switch (geometry)
  {
    case Geometry::Point:
      return dimension == 0;
    case Geometry::Segment:
      return dimension == 1;
    case Geometry::Triangle:
    case Geometry::Square:
      return dimension == 2;
    default:
      return dimension == 3;
  }
}

Cell ReadCell(TextScanner& scanner, int vertices, int dimension)
{
  static constexpr std::array kKinds{ " is no edge's: those of a plane mesh are segments (1).",
    " is no face's: faces and plane elements are triangles (2) or squares (3).",
    " is no solid's: elements are tetrahedra (4), cubes (5), prisms (6) or pyramids (7)." };
  Cell cell;
  cell.attribute = scanner.Integer("an attribute");
  const int geometry = scanner.Integer("an element's geometry type", 0, 7);
  cell.geometry = static_cast<Geometry>(geometry);
  if (!IsOfDimension(cell.geometry, dimension))
  {
    scanner.Fail("geometry type " + std::to_string(geometry) +
      kKinds.at(static_cast<std::size_t>(dimension - 1)));
  }
  for (int& v : std::span(cell.vertices).first(TableOf(cell.geometry).vertices))
  {
    v = scanner.Integer("a vertex", 0, vertices - 1);
  }
  return cell;
}
} // namespace pixelexact::mfem
