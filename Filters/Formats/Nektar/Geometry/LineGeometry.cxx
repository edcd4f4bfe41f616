// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/LineGeometry.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <limits>

namespace pixelexact::nektar
{
void MakeStrip(const std::string& name, Geometry& geometry)
{
  if (geometry.edges.size() == 0)
  {
    throw InvalidData(name + ": there are no segments.");
  }
  const Geometry lines = std::move(geometry);
  geometry = Geometry();
  geometry.dimension = 2;
  geometry.isLine = true;
  geometry.composites = lines.composites;
  geometry.notes = lines.notes;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::int64_t largest = 0;
  const Point& first = lines.vertices.begin()->second;
  for (const auto& [id, x] : lines.vertices)
  {
    if (x[1] != first[1] || x[2] != first[2])
    {
      throw Unsupported(name + ": vertex " + std::to_string(id) +
        " does not lie on the line of the others along x; only such one-dimensional geometries are "
        "read.");
    }
    low = std::min(low, x[0]);
    high = std::max(high, x[0]);
    largest = std::max(largest, id);
  }
  if (largest > std::numeric_limits<std::int64_t>::max() / 4)
  {
    throw Unsupported(
      name + ": vertex " + std::to_string(largest) + " has too large a number to be read.");
  }
  const std::int64_t shift = largest + 1;
  const double width = high > low ? high - low : 1.0;
  for (const auto& [id, x] : lines.vertices)
  {
    geometry.vertices.try_emplace(id, Point{ x[0], 0.0, 0.0 });
    geometry.vertices.try_emplace(id + shift, Point{ x[0], width, 0.0 });
    geometry.edges.try_emplace(id, Edge{ { id, id + shift }, -1 });
  }
  std::int64_t next = shift;
  for (const auto& [id, segment] : lines.edges)
  {
    const auto [a, b] = segment.vertices;
    const std::int64_t below = next++;
    const std::int64_t above = next++;
    geometry.edges.try_emplace(below, Edge{ { a, b }, -1 });
    geometry.edges.try_emplace(above, Edge{ { a + shift, b + shift }, -1 });
    Face face;
    face.corners = 4;
    face.edges = { below, b, above, a };
    face.vertices = { a, b, b + shift, a + shift };
    geometry.faces.try_emplace(id, face);
    geometry.solidOf.try_emplace(id, static_cast<int>(geometry.solids.size()));
    Solid element;
    element.id = id;
    element.faces[0] = id;
    geometry.solids.push_back(element);
  }
}
} // namespace pixelexact::nektar
