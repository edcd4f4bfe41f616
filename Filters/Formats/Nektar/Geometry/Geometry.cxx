// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/Geometry.h"

#include "Formats/Nektar/Files/Conditions.h"
#include "Formats/Nektar/Geometry/Composites.h"
#include "Formats/Nektar/Geometry/Curves.h"
#include "Formats/Nektar/Geometry/Entities.h"
#include "Formats/Nektar/Geometry/LineGeometry.h"

#include <algorithm>
#include <set>

namespace pixelexact::nektar
{
namespace
{
/// Of its elements (DIM), or of the space that they are in (SPACE).
std::int64_t DimensionOf(
  const Document& document, const pugi::xml_node& geometry, const char* name = "DIM")
{
  return geometry.attribute(name) ? document.Id(geometry, name) : 3;
}

/// The GEOMETRY of a file of the session; none where it has none. Refuses what is not read at all.
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

/// A note where parts of a partitioned mesh (they are numbered from 0) are not there. How many
/// there are, no file says: one alone is taken for too few.
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
