// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/Geometry.h"

#include "Core/Base/ParseWhole.h"

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <vector>

namespace pixelexact::nektar
{
namespace
{
int NumberOf(const Document& document, const pugi::xml_node& node)
{
  const std::int64_t number = document.Id(node, "ID");
  if (number > std::numeric_limits<std::int32_t>::max())
  {
    document.Fail(node, "the number of the composite is beyond 32 bits.");
  }
  return static_cast<int>(number);
}

void Join(const Document& document, const pugi::xml_node& node, Geometry::Composite&& part,
  std::vector<Geometry::Composite>& composites)
{
  const auto same = std::ranges::find(composites, part.number, &Geometry::Composite::number);
  if (same == composites.end())
  {
    composites.push_back(std::move(part));
    return;
  }
  const bool named = !part.name.empty() && !same->name.empty();
  if (part.boundary != same->boundary || (named && part.name != same->name))
  {
    document.Fail(node,
      "the composite is there twice, of another kind or name; files that are read together must "
      "be the parts of one mesh.");
  }
  same->name = same->name.empty() ? part.name : same->name;
  std::unordered_set<std::int64_t> known(same->members.begin(), same->members.end());
  std::ranges::copy_if(part.members, std::back_inserter(same->members),
    [&](std::int64_t member) { return known.insert(member).second; });
}
} // namespace

void ReadComposites(const Document& document, const pugi::xml_node& composites, Geometry& geometry)
{
  for (const auto& node : composites.children("C"))
  {
    const std::string whole = Document::Text(node);
    const std::string_view text = WithoutBlanks(whole);
    const auto open = text.find('[');
    const std::string_view tag = WithoutBlanks(text.substr(0, open));
    const bool isLine = geometry.dimension == 1;
    const bool isPlane = geometry.dimension == 2;
    const bool onPlane = std::ranges::find(kPlaneTags, tag, &SolidTag::tag) != std::end(kPlaneTags);
    const bool solid = isLine ? tag == kLineTag
      : isPlane               ? onPlane
                : std::ranges::find(kSolidTags, tag, &SolidTag::tag) != std::end(kSolidTags);
    const bool face = isLine ? tag == "V" : isPlane ? tag == "E" : tag == "F" || onPlane;
    if (!solid && !face)
    {
      continue; // what is below faces (in the plane, edges; on a line, vertices) is nobody's group
                // here
    }
    if (open == std::string_view::npos || text.back() != ']')
    {
      document.Fail(node, "the composite should read like H[0-65,70].");
    }
    Geometry::Composite composite;
    composite.number = NumberOf(document, node);
    composite.name = node.attribute("NAME").value();
    composite.boundary = face;
    composite.members = document.List(node, text.substr(open + 1, text.size() - open - 2),
      isLine      ? std::max(geometry.edges.size(), geometry.vertices.size())
        : !face   ? geometry.solids.size()
        : isPlane ? geometry.edges.size()
                  : geometry.faces.size());
    Join(document, node, std::move(composite), geometry.composites);
  }
}

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
