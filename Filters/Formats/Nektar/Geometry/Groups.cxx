// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/Groups.h"

#include <vector>

namespace pixelexact::nektar
{
void AddGroups(
  const Geometry& source, const FaceOwners& owners, const std::string& name, SolverModel& model)
{
  SolverMesh& mesh = model.mesh;
  mesh.attribute.assign(source.solids.size(), 0);
  std::vector<bool> taken(source.solids.size(), false);
  bool several = false;
  for (const auto& composite : source.composites)
  {
    mesh.groups.push_back({ composite.number, composite.name, composite.boundary });
    for (const auto id : composite.members)
    {
      const auto [first, last] = owners.equal_range(id);
      for (auto face = first; composite.boundary && face != last; ++face)
      {
        mesh.boundary.push_back({ face->second.element, face->second.face, composite.number });
      }
      if (const auto element = source.solidOf.find(id);
          !composite.boundary && element != source.solidOf.end())
      {
        several = several || taken[element->second];
        mesh.attribute[element->second] =
          taken[element->second] ? mesh.attribute[element->second] : composite.number;
        taken[element->second] = true;
      }
    }
  }
  if (several)
  {
    model.notes.push_back(
      name + ": elements lie in several composites; Attribute holds the first one of each.");
  }
}
} // namespace pixelexact::nektar
