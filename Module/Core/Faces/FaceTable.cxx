// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FaceTable.h"

#include "Core/Faces/FaceContacts.h"
#include "Core/Faces/FacePairs.h"
#include "Core/Faces/FaceSampler.h"
#include "Core/Shape/ShapeFace.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace pixelexact
{
FaceTable::FaceTable(const ElementIndex& index)
  : Numbers(index.GetMesh())
{
  const Mesh& mesh = index.GetMesh();
  std::vector<Vec3> uncertainty(static_cast<std::size_t>(mesh.Elements()));
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e) { uncertainty[static_cast<std::size_t>(e)] = ImageUncertainty(mesh, e); });
  int order = 1;
  for (const Space& space : mesh.map.spaces)
  {
    order = std::max(order, space.MaxOrder());
  }
  const FaceGrids grids(order);
  Neighbours = FindFacePairs(mesh, Numbers, grids, uncertainty);
  Kinds.assign(Neighbours.size(), FaceKind::Interior);

  std::vector<ElementFace> alone;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    for (int f = 0; f < Numbers.FacesOfElement(e); ++f)
    {
      if (NeighbourOf(e, f) == ElementFace{})
      {
        alone.push_back({ e, f });
      }
    }
  }
  const auto contacts = FindFaceContacts(index, grids, uncertainty, alone);
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    const std::size_t number = Numbers.NumberOf(alone[i].element, alone[i].face);
    Kinds[number] = contacts[i].kind;
    Neighbours[number] = contacts[i].neighbour;
  }
}

std::int64_t FaceTable::CountOf(FaceKind kind) const
{
  return std::ranges::count(Kinds, kind);
}

std::size_t FaceTable::MemoryUsage() const
{
  return Numbers.MemoryUsage() + Neighbours.capacity() * sizeof(ElementFace) + Kinds.capacity();
}

FaceNumbers::FaceNumbers(const Mesh& mesh)
  : First(static_cast<std::size_t>(mesh.Elements()) + 1)
{
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const auto at = static_cast<std::size_t>(e);
    First[at + 1] = First[at] + FacesOf(mesh.ShapeOf(e)).size();
  }
}
} // namespace pixelexact
