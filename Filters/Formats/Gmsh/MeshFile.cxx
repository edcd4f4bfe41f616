// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/MeshFile.h"

#include <algorithm>
#include <limits>

namespace pixelexact::gmsh
{
namespace
{
using Key = std::array<std::int32_t, 4>; ///< nodes, ascending

struct KnownFace
{
  Key key;
  std::int32_t attribute;
  bool owned = false;
};

Key Sorted(Key key)
{
  std::ranges::sort(key);
  return key;
}
} // namespace

const std::uint64_t* TagIndex::Finish()
{
  using Pair = std::pair<std::uint64_t, std::int32_t>;
  if (!std::ranges::is_sorted(Pairs, {}, &Pair::first))
  {
    std::ranges::sort(Pairs, {}, &Pair::first);
  }
  const auto twice = std::ranges::adjacent_find(Pairs, {}, &Pair::first);
  if (twice != Pairs.end())
  {
    Twice = twice->first;
    return &Twice;
  }
  if (Pairs.empty())
  {
    return nullptr;
  }
  First = Pairs.front().first;
  const std::uint64_t span = Pairs.back().first - First;
  if (span / 4 <= Pairs.size())
  {
    Dense.assign(static_cast<std::size_t>(span) + 1, -1);
    for (const auto& [tag, place] : Pairs)
    {
      Dense[static_cast<std::size_t>(tag - First)] = place;
    }
    std::vector<Pair>().swap(Pairs); // with its memory
  }
  return nullptr;
}

std::int32_t TagIndex::Find(std::uint64_t tag) const
{
  if (!Dense.empty())
  {
    return tag >= First && tag - First < Dense.size() ? Dense[static_cast<std::size_t>(tag - First)]
                                                      : -1;
  }
  const auto found =
    std::ranges::lower_bound(Pairs, tag, {}, [](const auto& pair) { return pair.first; });
  return found != Pairs.end() && found->first == tag ? found->second : -1;
}

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

std::vector<BoundaryFace> FindFaces(const MeshFile& mesh, bool byEntity, std::size_t& strangers)
{
  std::vector<KnownFace> known;
  known.reserve(mesh.faces.size());
  for (const SurfaceElement& face : mesh.faces)
  {
    if (byEntity || face.physical != 0)
    {
      known.push_back({ Sorted(face.corners), byEntity ? face.entity : face.physical });
    }
  }
  std::ranges::stable_sort(known, {}, &KnownFace::key);
  std::vector<BoundaryFace> found;
  for (std::size_t e = 0; !known.empty() && e < mesh.elements.size(); ++e)
  {
    const Solid& element = mesh.elements[e];
    const auto nodes = mesh.NodesOf(element);
    const auto& faces =
      mesh.dimension == 3 ? FacesOf(element.type->shape) : SidesOf(element.type->corners == 3);
    for (const ElementFace& face : faces)
    {
      Key key{ -1, -1, -1, -1 };
      std::ranges::transform(
        face.corners, key.begin(), [&](int corner) { return corner < 0 ? -1 : nodes[corner]; });
      const Key sorted = Sorted(key);
      auto match = std::ranges::lower_bound(known, sorted, {}, &KnownFace::key);
      for (; match != known.end() && match->key == sorted; ++match)
      {
        match->owned = true;
        found.push_back({ static_cast<std::int32_t>(e), static_cast<std::int8_t>(face.vtkFace),
          match->attribute });
      }
    }
  }
  strangers = static_cast<std::size_t>(
    std::ranges::count_if(known, [](const KnownFace& face) { return !face.owned; }));
  return found;
}
} // namespace pixelexact::gmsh
