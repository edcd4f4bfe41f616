// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/Geometry.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Formats/Nektar/Files/Conditions.h"
#include "Formats/Nektar/Files/Expression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace pixelexact::nektar
{
namespace
{
double ReadExpression(const Document& document, const pugi::xml_node& node,
  const std::string& attribute, double usual, const Parameters& parameters)
{
  const pugi::xml_attribute text = node.attribute(attribute.c_str());
  if (!text)
  {
    return usual;
  }
  try
  {
    return Evaluate(
      WithoutBlanks(text.value()), [&](std::string_view name) { return parameters.Find(name); });
  }
  catch (const InvalidData& error)
  {
    document.Fail(node,
      attribute + "=\"" + std::string(text.value()).substr(0, 60) +
        "\" is no expression that has a value: " + error.what() + ".");
  }
}

/// The attributes XSCALE, YSCALE, ZSCALE, XMOVE, YMOVE, ZMOVE and ZROT of a VERTEX element, which
/// are expressions of the session's parameters. Throws InvalidData where one is not.
Transform ReadTransform(
  const Document& document, const pugi::xml_node& vertices, const Parameters& parameters)
{
  Transform transform;
  for (int d = 0; d < 3; ++d)
  {
    const std::string axis(1, "XYZ"[d]);
    transform.scale[d] = ReadExpression(document, vertices, axis + "SCALE", 1.0, parameters);
    transform.move[d] = ReadExpression(document, vertices, axis + "MOVE", 0.0, parameters);
  }
  transform.angle = ReadExpression(document, vertices, "ZROT", 0.0, parameters);
  return transform;
}

/// Converts a geometry of segments (its edges, along x) to quadrilaterals with the segments'
/// numbers, whose first direction is that of the segments. Vertices, also those of composites,
/// become the sides at their ends. `name`: of the file, for messages. Throws InvalidData without
/// segments, Unsupported for segments that are not along x.
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

/// The dimension of the elements (DIM) or of the space that contains them (SPACE).
std::int64_t DimensionOf(
  const Document& document, const pugi::xml_node& geometry, const char* name = "DIM")
{
  return geometry.attribute(name) ? document.Id(geometry, name) : 3;
}

/// The GEOMETRY of a file of the session; none where it has none. Throws for unsupported
/// geometries.
pugi::xml_node FindGeometry(const Document& document, std::span<const Document* const> session)
{
  const pugi::xml_node geometry = document.Only(document.Root(), "GEOMETRY");
  if (const std::string mesh = geometry.attribute("HDF5FILE").value(); !mesh.empty())
  {
    if (std::ranges::none_of(session,
          [&](const Document* file)
          { return file->BaseName() == mesh.substr(mesh.rfind('/') + 1); }))
    {
      document.Fail(geometry,
        "the geometry is in the HDF5 file " + mesh +
          ", which is not there; put it beside this file, or name it as well.");
    }
    return {}; // the other file's is read
  }
  if (geometry)
  {
    const std::int64_t own = DimensionOf(document, geometry);
    const std::int64_t space = DimensionOf(document, geometry, "SPACE");
    const auto homogeneous = HomogeneousType(session);
    const bool isLine = own == 1 && homogeneous && homogeneous->ends_with("2D");
    if (homogeneous && own != 3 && !isLine && !(own == 2 && homogeneous->ends_with("1D")))
    {
      document.FailUnsupported(geometry,
        "the session is HOMOGENEOUS (" + *homogeneous + ") over a mesh of dimension " +
          std::to_string(own) +
          "; 1D over two-dimensional and 2D over one-dimensional ones are "
          "read: " +
          HomogeneousRemedy());
    }
    if ((own < 2 && !isLine) || own > 3 || space < own || space > 3)
    {
      document.FailUnsupported(geometry,
        "only two- and three-dimensional geometries are read, and one-dimensional ones of sessions "
        "that are HOMOGENEOUS (2D).");
    }
  }
  return geometry;
}

struct Part
{
  const Document* file;
  pugi::xml_node geometry;
  Transform transform;
};

/// Adds a note where parts of a partitioned mesh, which are numbered from 0, are missing. No file
/// contains the number of parts, so a single part also counts as incomplete.
void NoteMissingParts(const std::vector<Part>& parts, Geometry& geometry)
{
  std::set<std::int64_t> numbers;
  for (const Part& part : parts)
  {
    if (part.geometry.attribute("PARTITION"))
    {
      numbers.insert(part.file->Id(part.geometry, "PARTITION"));
    }
  }
  if (numbers.size() == 1 ||
    (!numbers.empty() && *numbers.rbegin() >= static_cast<std::int64_t>(numbers.size())))
  {
    geometry.notes.push_back(parts.front().file->Name() +
      ": the mesh is partitioned and not all of its parts are named; name all of them (P*.xml) for "
      "the whole.");
  }
}
} // namespace

Point Transform::operator()(Point x) const
{
  for (int d = 0; d < 3; ++d)
  {
    x[d] = x[d] * scale[d] + move[d];
  }
  if (angle != 0.0)
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    x = { x[0] * c - x[1] * s, x[0] * s + x[1] * c, x[2] };
  }
  return x;
}

Geometry ReadGeometry(std::span<const Document* const> session)
{
  const Parameters parameters(session);
  std::vector<Part> parts;
  Geometry target;
  for (const Document* file : session)
  {
    target.notes.insert(target.notes.end(), file->Notes().begin(), file->Notes().end());
    if (const pugi::xml_node geometry = FindGeometry(*file, session))
    {
      parts.push_back(
        { file, geometry, ReadTransform(*file, geometry.child("VERTEX"), parameters) });
    }
  }
  for (const Part& part : parts)
  {
    const auto dimension = static_cast<int>(DimensionOf(*part.file, part.geometry));
    if (&part != parts.data() && dimension != target.dimension)
    {
      part.file->Fail(part.geometry,
        "the geometries of the session are of different dimensions; name the parts of one mesh.");
    }
    target.dimension = dimension;
  }
  for (const Part& part : parts)
  {
    ReadEntities(*part.file, part.geometry, part.transform, target);
  }
  for (const Part& part : parts)
  {
    ReadCurves(*part.file, part.file->Only(part.geometry, "CURVED"), part.transform, target);
    ReadComposites(*part.file, part.file->Only(part.geometry, "COMPOSITE"), target);
  }
  NoteMissingParts(parts, target);
  if (target.dimension == 1)
  {
    MakeStrip(parts.front().file->Name(), target);
  }
  return target;
}
} // namespace pixelexact::nektar
