// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/SurfaceFaces.h"

#include "Formats/Gmsh/NodeOrder.h"

#include <algorithm>

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
