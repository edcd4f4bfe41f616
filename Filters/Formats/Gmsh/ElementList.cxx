// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/ElementList.h"

#include <algorithm>
#include <limits>

namespace pixelexact::gmsh
{
ElementList::ElementList(MeshFile& mesh, std::size_t count)
  : Mesh(mesh)
{
  Mesh.elements.reserve(count);
  Mesh.elementOf.Reserve(count);
}

void ElementList::Add(
  Scanner& scanner, int typeNumber, std::uint64_t number, const Membership& where)
{
  const ElementType* type = FindType(typeNumber);
  if (type == nullptr)
  {
    scanner.FailUnsupported("element " + std::to_string(number) + " is of type " +
      std::to_string(typeNumber) +
      ", which is none of the triangles, quadrilaterals, tetrahedra, hexahedra, prisms and "
      "pyramids of order 1 and more that are read; save the file without such elements.");
  }
  const bool newFormat = scanner.GetEncoding().version > 4.0;
  Nodes.resize(static_cast<std::size_t>(type->nodes));
  for (std::int32_t& node : Nodes)
  {
    const std::uint64_t tag = newFormat
      ? scanner.Size("an element's node")
      : static_cast<std::uint32_t>(scanner.Int("an element's node"));
    node = Mesh.nodeOf.Find(tag);
    if (node < 0)
    {
      scanner.Fail("element " + std::to_string(number) + " has the node " + std::to_string(tag) +
        ", which is not in $Nodes.");
    }
  }
  if (type->dimension == Mesh.dimension)
  {
    AddSolid(*type, number, where);
    return;
  }
  ++Mesh.lower;
  if (type->dimension == Mesh.dimension - 1)
  {
    AddSurface(*type, where);
  }
}

/// Version 2.2 has an element once for each of its physical groups, one after the other.
bool ElementList::RepeatsTheLast(const ElementType& type, const Membership& where) const
{
  if (Mesh.elements.empty())
  {
    return false;
  }
  const Solid& last = Mesh.elements.back();
  return last.type == &type && last.entity == where.entity && !where.physical.empty() &&
    last.physical != where.physical[0] && std::ranges::equal(Mesh.NodesOf(last), Nodes);
}

void ElementList::AddSolid(const ElementType& type, std::uint64_t number, const Membership& where)
{
  const auto place = static_cast<std::int32_t>(Mesh.elements.size());
  if (RepeatsTheLast(type, where))
  {
    Mesh.elementOf.Add(number, place - 1);
    Mesh.inSeveralGroups += Repeated == place - 1 ? 0 : 1;
    Repeated = place - 1;
    return;
  }
  Mesh.elementOf.Add(number, place);
  Mesh.inSeveralGroups += where.physical.size() > 1 ? 1 : 0;
  Mesh.elements.push_back({ &type, static_cast<std::int64_t>(number),
    where.physical.empty() ? 0 : where.physical[0], where.entity, Mesh.elementNodes.size() });
  Mesh.elementNodes.insert(Mesh.elementNodes.end(), Nodes.begin(), Nodes.end());
}

void ElementList::AddSurface(const ElementType& type, const Membership& where)
{
  SurfaceElement face;
  std::copy_n(Nodes.begin(), type.corners, face.corners.begin());
  face.entity = where.entity;
  if (where.physical.empty())
  {
    Mesh.faces.push_back(face);
  }
  for (const std::int32_t physical : where.physical)
  {
    face.physical = physical;
    Mesh.faces.push_back(face);
  }
}
} // namespace pixelexact::gmsh
