// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry.h"

#include "Formats/Nektar/Curves.h"

#include <algorithm>
#include <cmath>

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

struct SolidTag
{
  const char* tag;
  Shape shape;
};
constexpr SolidTag kSolidTags[] = { { "A", Shape::Tetrahedron }, { "P", Shape::Pyramid },
  { "R", Shape::Prism }, { "H", Shape::Hexahedron } };

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

double Factor(const Document& document, const pugi::xml_node& node, const char* name, double usual)
{
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute)
  {
    return usual;
  }
  const double value = attribute.as_double(NAN);
  if (!std::isfinite(value))
  {
    document.FailUnsupported(node,
      std::string(name) +
        " is no plain number; write the number itself (expressions are not evaluated).");
  }
  return value;
}

class GeometryReader
{
public:
  GeometryReader(const Document& document, const pugi::xml_node& geometry)
    : File(document)
    , Node(geometry)
  {
  }

  Geometry Read()
  {
    CheckForm();
    ReadVertices();
    ReadEdges();
    ReadFaces<3>("T");
    ReadFaces<4>("Q");
    ReadSolids<4>(kSolidTags[0]);
    ReadSolids<5>(kSolidTags[1]);
    ReadSolids<5>(kSolidTags[2]);
    ReadSolids<6>(kSolidTags[3]);
    for (const auto& curved : Node.children("CURVED"))
    {
      ReadCurves(File, curved, Target);
    }
    ReadComposites();
    return std::move(Target);
  }

private:
  void CheckForm() const
  {
    if (Node.attribute("HDF5FILE"))
    {
      File.FailUnsupported(Node,
        "the geometry is in an HDF5 file, which is not read; write it as "
        "XML (NekMesh mesh.nekg mesh.xml).");
    }
    if (Node.attribute("DIM").as_int(3) != 3 || Node.attribute("SPACE").as_int(3) != 3)
    {
      File.FailUnsupported(Node, "only three-dimensional geometries are read.");
    }
  }

  void ReadVertices()
  {
    const pugi::xml_node parent = Node.child("VERTEX");
    Point scale{};
    Point move{};
    for (int d = 0; d < 3; ++d)
    {
      const std::string axis(1, "XYZ"[d]);
      scale[d] = Factor(File, parent, (axis + "SCALE").c_str(), 1.0);
      move[d] = Factor(File, parent, (axis + "MOVE").c_str(), 0.0);
    }
    const auto add = [&](std::int64_t id, Point x)
    {
      for (int d = 0; d < 3; ++d)
      {
        x[d] = x[d] * scale[d] + move[d];
      }
      Target.vertices[id] = x;
    };
    if (File.IsCompressed(parent))
    {
      for (const auto& record :
        File.Records<VertexRecord>(parent, File.MostBytes() / sizeof(VertexRecord)))
      {
        add(record.id, record.x);
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
      add(File.Id(node, "ID"), { numbers[0], numbers[1], numbers[2] });
    }
  }

  void ReadEdges()
  {
    const auto add =
      [&](const pugi::xml_node& node, std::int64_t id, const std::array<std::int64_t, 2>& vertices)
    {
      for (const auto v : vertices)
      {
        Require(node, Target.vertices.contains(v), "edge", id, "vertex", v);
      }
      Target.edges[id] = { vertices, -1 };
    };
    const pugi::xml_node parent = Node.child("EDGE");
    if (File.IsCompressed(parent))
    {
      // The list itself is the block.
      const std::size_t most = File.MostBytes() / sizeof(EntityRecord<2>);
      for (const auto& record : File.Records<EntityRecord<2>>(parent, most))
      {
        add(parent, record.id, record.parts);
      }
      return;
    }
    ForEntities<2>(File, parent, "E", add);
  }

  template <std::size_t N>
  void ReadFaces(const char* tag)
  {
    ForEntities<N>(File, Node.child("FACE"), tag,
      [&](const pugi::xml_node& node, std::int64_t id, const std::array<std::int64_t, N>& edges)
      {
        Face face;
        face.corners = N;
        std::ranges::copy(edges, face.edges.begin());
        for (const auto e : edges)
        {
          Require(node, Target.edges.contains(e), "face", id, "edge", e);
        }
        // Vertex k begins edge k: it is shared with the edge before.
        for (std::size_t k = 0; k < N; ++k)
        {
          face.vertices[k] = Shared(node, id, edges[(k + N - 1) % N], edges[k]);
        }
        Target.faces[id] = face;
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
    ForEntities<N>(File, Node.child("ELEMENT"), tag.tag,
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
        Target.solids.push_back(solid);
      });
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

  void ReadComposites()
  {
    for (const auto& node : Node.child("COMPOSITE").children("C"))
    {
      const std::string_view text = Trim(node.child_value());
      const auto open = text.find('[');
      const std::string_view tag = Trim(text.substr(0, open));
      const bool solid = tag.size() == 1 &&
        std::ranges::any_of(kSolidTags, [&](const SolidTag& s) { return s.tag == tag; });
      const bool face = tag == "F" || tag == "T" || tag == "Q";
      if (!solid && !face)
      {
        continue; // edges and vertices are nobody's group here
      }
      if (open == std::string_view::npos || text.back() != ']')
      {
        File.Fail(node, "the composite should read like H[0-65,70].");
      }
      Geometry::Composite composite;
      composite.number = static_cast<int>(std::min<std::int64_t>(File.Id(node, "ID"), 1 << 30));
      composite.name = node.attribute("NAME").value();
      composite.boundary = face;
      composite.members = File.List(node, text.substr(open + 1, text.size() - open - 2),
        face ? Target.faces.size() : Target.solids.size());
      Target.composites.push_back(std::move(composite));
    }
  }

  const Document& File;
  pugi::xml_node Node;
  Geometry Target;
};
} // namespace

Geometry ReadGeometry(const Document& document)
{
  return GeometryReader(document, document.Root().child("GEOMETRY")).Read();
}
} // namespace pixelexact::nektar
