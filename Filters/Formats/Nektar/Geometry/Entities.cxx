// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/Geometry.h"

#include <algorithm>
#include <functional>

namespace pixelexact::nektar
{
namespace
{
struct VertexRecord
{
  std::int64_t id;
  Point x;
};
template <std::size_t N>
struct EntityRecord
{
  std::int64_t id;
  std::array<std::int64_t, N> parts;
};

/// Visits the entities of N parts below `parent`: plain elements of the tag, each with its ID, or
/// compressed records.
template <std::size_t N, class Function>
void ForEntities(
  const Document& document, const pugi::xml_node& parent, const char* tag, Function&& function)
{
  for (const auto& node : parent.children(tag))
  {
    if (document.IsCompressed(node))
    {
      const std::size_t most = document.MostBytes() / sizeof(EntityRecord<N>);
      for (const auto& record : document.Records<EntityRecord<N>>(node, most))
      {
        function(node, record.id, record.parts);
      }
      continue;
    }
    const auto numbers = document.Integers(node, N);
    std::array<std::int64_t, N> parts{};
    std::ranges::copy(numbers, parts.begin());
    function(node, document.Id(node, "ID"), parts);
  }
}

/// Reads one file's entities into a geometry that may already contain those of other parts.
class EntityReader
{
public:
  EntityReader(const Document& document, const pugi::xml_node& geometry, const Transform& transform,
    Geometry& target)
    : File(document)
    , Node(geometry)
    , Place(transform)
    , Target(target)
  {
  }

  void Read()
  {
    ReadVertices();
    if (Target.dimension == 1)
    {
      ReadLines(File.Only(Node, "ELEMENT"), kLineTag.data());
      return;
    }
    ReadEdges();
    if (Target.dimension == 2)
    {
      ReadPlaneElements<3>(kPlaneTags[0]);
      ReadPlaneElements<4>(kPlaneTags[1]);
      return;
    }
    ReadFaces<3>("FACE", "T");
    ReadFaces<4>("FACE", "Q");
    ReadSolids<4>(kSolidTags[0]);
    ReadSolids<5>(kSolidTags[1]);
    ReadSolids<5>(kSolidTags[2]);
    ReadSolids<6>(kSolidTags[3]);
  }

private:
  /// Fails where an entity occurs in several parts and differs.
  void RequireSame(const pugi::xml_node& node, bool same, const char* what, std::int64_t id) const
  {
    if (!same)
    {
      File.Fail(node,
        std::string(what) + " " + std::to_string(id) +
          " is there twice, and not the same; files that are read together must be the parts of "
          "one mesh.");
    }
  }

  template <class Map, class Value>
  void Insert(
    const pugi::xml_node& node, Map& map, const char* what, std::int64_t id, const Value& value)
  {
    const auto [at, isNew] = map.try_emplace(id, value);
    RequireSame(node, isNew || at->second == value, what, id);
  }

  void ReadVertices()
  {
    const pugi::xml_node parent = File.Only(Node, "VERTEX");
    if (File.IsCompressed(parent))
    {
      for (const auto& record :
        File.Records<VertexRecord>(parent, File.MostBytes() / sizeof(VertexRecord)))
      {
        Insert(parent, Target.vertices, "vertex", record.id, Place(record.x));
      }
      return;
    }
    for (const auto& node : parent.children("V"))
    {
      const auto numbers = File.Numbers(node);
      if (numbers.size() != 3)
      {
        File.Fail(node, "a vertex needs three coordinates.");
      }
      Insert(node, Target.vertices, "vertex", File.Id(node, "ID"),
        Place({ numbers[0], numbers[1], numbers[2] }));
    }
  }

  void AddEdge(
    const pugi::xml_node& node, std::int64_t id, const std::array<std::int64_t, 2>& vertices)
  {
    for (const auto v : vertices)
    {
      Require(node, Target.vertices.contains(v), "edge", id, "vertex", v);
    }
    Insert(node, Target.edges, "edge", id, Edge{ vertices, -1 });
  }

  void ReadEdges()
  {
    const pugi::xml_node parent = File.Only(Node, "EDGE");
    if (File.IsCompressed(parent))
    {
      // The list itself is the compressed block.
      const std::size_t most = File.MostBytes() / sizeof(EntityRecord<2>);
      for (const auto& record : File.Records<EntityRecord<2>>(parent, most))
      {
        AddEdge(parent, record.id, record.parts);
      }
      return;
    }
    ReadLines(parent, "E");
  }

  void ReadLines(const pugi::xml_node& parent, const char* tag)
  {
    ForEntities<2>(File, parent, tag,
      [this](const pugi::xml_node& node, std::int64_t id,
        const std::array<std::int64_t, 2>& vertices) { AddEdge(node, id, vertices); });
  }

  /// An element of a plane mesh is a face with the same number.
  template <std::size_t N>
  void ReadPlaneElements(const SolidTag& tag)
  {
    ReadFaces<N>("ELEMENT", tag.tag.data(),
      [&](const pugi::xml_node& node, std::int64_t id)
      {
        Solid element;
        element.id = id;
        element.shape = tag.shape;
        element.faces[0] = id;
        AddSolid(node, element);
      });
  }

  template <std::size_t N>
  void ReadFaces(const char* list, const char* tag,
    const std::function<void(const pugi::xml_node&, std::int64_t)>& also = {})
  {
    ForEntities<N>(File, File.Only(Node, list), tag,
      [&](const pugi::xml_node& node, std::int64_t id, const std::array<std::int64_t, N>& edges)
      {
        Face face;
        face.corners = N;
        std::ranges::copy(edges, face.edges.begin());
        for (const auto e : edges)
        {
          Require(node, Target.edges.contains(e), "face", id, "edge", e);
        }
        // Vertex k is shared by edge k, which begins there, and the edge before it.
        for (std::size_t k = 0; k < N; ++k)
        {
          face.vertices[k] = Shared(node, id, edges[(k + N - 1) % N], edges[k]);
        }
        Insert(node, Target.faces, "face", id, face);
        if (also)
        {
          also(node, id);
        }
      });
  }

  std::int64_t Shared(
    const pugi::xml_node& node, std::int64_t face, std::int64_t a, std::int64_t b) const
  {
    const auto& first = Target.edges.at(a).vertices;
    const auto& second = Target.edges.at(b).vertices;
    const auto* found = std::ranges::find_first_of(first, second);
    if (found == first.end())
    {
      File.Fail(node,
        "edges " + std::to_string(a) + " and " + std::to_string(b) + " of face " +
          std::to_string(face) + " do not meet; the file contradicts itself.");
    }
    return *found;
  }

  template <std::size_t N>
  void ReadSolids(const SolidTag& tag)
  {
    ForEntities<N>(File, File.Only(Node, "ELEMENT"), tag.tag.data(),
      [&](const pugi::xml_node& node, std::int64_t id, const std::array<std::int64_t, N>& faces)
      {
        Solid solid;
        solid.id = id;
        solid.shape = tag.shape;
        std::ranges::copy(faces, solid.faces.begin());
        for (const auto f : faces)
        {
          Require(node, Target.faces.contains(f), "element", id, "face", f);
        }
        AddSolid(node, solid);
      });
  }

  void AddSolid(const pugi::xml_node& node, const Solid& solid)
  {
    const auto [at, isNew] =
      Target.solidOf.try_emplace(solid.id, static_cast<int>(Target.solids.size()));
    if (isNew)
    {
      Target.solids.push_back(solid);
    }
    RequireSame(node, Target.solids[at->second] == solid, "element", solid.id);
  }

  void Require(const pugi::xml_node& node, bool known, const char* what, std::int64_t id,
    const char* part, std::int64_t partId) const
  {
    if (!known)
    {
      File.Fail(node,
        std::string(what) + " " + std::to_string(id) + " has the " + part + " " +
          std::to_string(partId) + ", which is not there; the file contradicts itself.");
    }
  }

  const Document& File;
  pugi::xml_node Node;
  const Transform& Place;
  Geometry& Target;
};
} // namespace

void ReadEntities(const Document& document, const pugi::xml_node& geometry,
  const Transform& transform, Geometry& target)
{
  EntityReader(document, geometry, transform, target).Read();
}
} // namespace pixelexact::nektar
