// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Reader.h"

#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/Nektar/Fields/FieldBasis.h"
#include "Formats/Nektar/Files/Conditions.h"
#include "Formats/Nektar/Geometry/FaceMaps.h"
#include "Formats/Nektar/Geometry/Geometry.h"
#include "Formats/Nektar/Geometry/PlaneModel.h"
#include "Formats/Nektar/Geometry/ReferenceShapes.h"

#include <algorithm>
#include <deque>
#include <map>
#include <unordered_set>

namespace pixelexact::nektar
{
namespace
{
/// A solid with its vertices found.
struct Element
{
  const Solid* solid;
  std::array<std::int64_t, 8> vertices{};
};

/// The vertex that three faces have in common.
std::int64_t CommonVertex(
  const Geometry& geometry, const Solid& solid, const std::array<int, 3>& meeting)
{
  const auto has = [&](int face, std::int64_t v)
  {
    const Face& f = geometry.faces.at(solid.faces[face]);
    return std::ranges::count(std::span(f.vertices).first(f.corners), v) > 0;
  };
  const Face& first = geometry.faces.at(solid.faces[meeting[0]]);
  for (const auto v : std::span(first.vertices).first(first.corners))
  {
    if (has(meeting[1], v) && has(meeting[2], v))
    {
      return v;
    }
  }
  throw InvalidData("element " + std::to_string(solid.id) +
    ": its faces do not close; they are not listed in Nektar++'s order.");
}

class ModelBuilder
{
public:
  ModelBuilder(const Geometry& geometry, std::string name)
    : Source(geometry)
    , Name(std::move(name))
  {
    FindElements();
    AddMap();
    AddCorners();
    AddComposites();
  }

  SolverModel Model;

private:
  void FindElements();
  void AddMap();
  void AddCorners();
  void AddComposites();
  LongVec3 PositionOf(
    const FaceMaps& maps, const Element& element, const BoundaryBasis::Node& node) const;

  const Geometry& Source;
  std::string Name;
  std::vector<Element> Elements;
};

void ModelBuilder::FindElements()
{
  for (const Solid& solid : Source.solids)
  {
    const SolidTable& table = TableOf(solid.shape);
    Element element{ &solid, {} };
    for (std::size_t f = 0; f < table.faces.size(); ++f)
    {
      if (Source.faces.at(solid.faces[f]).corners != table.faces[f].corners)
      {
        throw InvalidData(Name + ": face " + std::to_string(f) + " of element " +
          std::to_string(solid.id) + " has the wrong number of edges for a " +
          pixelexact::Name(solid.shape) + ".");
      }
    }
    for (std::size_t v = 0; v < table.meeting.size(); ++v)
    {
      element.vertices[v] =
        NameErrors(Name, [&] { return CommonVertex(Source, solid, table.meeting[v]); });
    }
    Elements.push_back(element);
  }
  if (Elements.empty())
  {
    throw InvalidData(Name + ": there are no solid elements.");
  }
}

/// Converts the element's own order of a face's vertices to the face's order.
LongVec3 ModelBuilder::PositionOf(
  const FaceMaps& maps, const Element& element, const BoundaryBasis::Node& node) const
{
  const SolidFace& local = TableOf(element.solid->shape).faces[node.face];
  const Face& face = Source.faces.at(element.solid->faces[node.face]);
  std::array<long double, 4> weights{};
  for (int k = 0; k < local.corners; ++k)
  {
    const auto vertices = std::span(face.vertices).first(face.corners);
    const auto found = std::ranges::find(vertices, element.vertices[local.vertices[k]]);
    if (found == vertices.end())
    {
      throw InvalidData(Name + ": the faces of element " + std::to_string(element.solid->id) +
        " are not listed in Nektar++'s order.");
    }
    weights[found - vertices.begin()] = node.weights[k];
  }
  return maps.At(face, weights);
}

void ModelBuilder::AddMap()
{
  const FaceMaps maps(Source);
  std::map<std::pair<Shape, int>, BoundaryBasis> known;
  std::vector<const ElementBasis*> bases;
  std::vector<const BoundaryBasis*> boundaries;
  for (const Element& element : Elements)
  {
    int order = 1;
    for (std::size_t f = 0; f < TableOf(element.solid->shape).faces.size(); ++f)
    {
      order = std::max(order, maps.OrderOf(Source.faces.at(element.solid->faces[f])));
    }
    const std::pair key(element.solid->shape, order);
    if (!known.contains(key))
    {
      known[key] = NameErrors(Name + ": element " + std::to_string(element.solid->id),
        [&] { return MakeBoundaryBasis(element.solid->shape, order); });
    }
    boundaries.push_back(&known.at(key));
    bases.push_back(&known.at(key).basis);
  }
  AssembleMap(
    bases,
    [&](std::size_t e, std::span<double> source)
    {
      const auto& nodes = boundaries[e]->nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const LongVec3 x = PositionOf(maps, Elements[e], nodes[i]);
        for (std::size_t c = 0; c < 3; ++c)
        {
          source[c * nodes.size() + i] = static_cast<double>(x[c]);
        }
      }
    },
    [&](std::size_t e) { return Name + ": element " + std::to_string(Elements[e].solid->id); },
    Model.mesh);
}

void ModelBuilder::AddCorners()
{
  for (const Element& element : Elements)
  {
    Model.mesh.number.push_back(element.solid->id);
    Corners& corners = Model.mesh.corners.emplace_back();
    const auto& vtk = TableOf(element.solid->shape).vtkVertex;
    for (std::size_t k = 0; k < vtk.size(); ++k)
    {
      corners[k] = element.vertices[vtk[k]];
    }
  }
}

void ModelBuilder::AddComposites()
{
  std::unordered_set<std::int64_t> named;
  for (const auto& composite : Source.composites)
  {
    if (composite.boundary)
    {
      named.insert(composite.members.begin(), composite.members.end());
    }
  }
  FaceOwners owners;
  for (std::size_t e = 0; e < Elements.size() && !named.empty(); ++e)
  {
    const auto& faces = TableOf(Elements[e].solid->shape).faces;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const std::int64_t face = Elements[e].solid->faces[f];
      if (named.contains(face))
      {
        owners.emplace(face, BoundaryFace{ static_cast<std::int32_t>(e), faces[f].vtkFace, 0 });
      }
    }
  }
  AddGroups(Source, owners, Name, Model);
}
} // namespace

SessionMesh ReadMesh(const std::vector<NamedText>& sessions)
{
  std::deque<Document> documents;
  std::vector<const Document*> session;
  std::string name;
  for (const NamedText& text : sessions)
  {
    const Document& document = documents.emplace_back(text);
    if (const pugi::xml_node second = document.Root().next_sibling("NEKTAR"))
    {
      document.Fail(second, "there is a second one; name one file for each.");
    }
    session.push_back(&document);
    name = name.empty() && document.Root().child("GEOMETRY") ? text.name : name;
  }
  if (name.empty())
  {
    throw InvalidData((sessions.empty() ? std::string("no session") : sessions.front().name) +
      ": no file has an element GEOMETRY; name the file that holds the mesh as well.");
  }
  const Geometry geometry = ReadGeometry(session);
  const Parameters parameters(session);
  const auto stripDistance = parameters.Find("DistStrip");
  documents.clear(); // all is in the geometry now
  SolverModel model = geometry.dimension == 2 ? MakePlaneModel(geometry, name)
                                              : std::move(ModelBuilder(geometry, name).Model);
  model.notes.insert(model.notes.end(), geometry.notes.begin(), geometry.notes.end());
  model.parameters = parameters.All();
  return { std::move(model), name, geometry.isLine, stripDistance };
}

void RequireFields(const SessionMesh& mesh)
{
  if (mesh.isLine)
  {
    throw Unsupported(mesh.name +
      ": the mesh is one-dimensional, and its functions along y and z are in the field files; name "
      "one of them, too.");
  }
}

SessionMesh OutlineOf(const SessionMesh& mesh)
{
  const SolverMesh& whole = mesh.model.mesh;
  SessionMesh outline{ {}, mesh.name, mesh.isLine, mesh.stripDistance };
  outline.model.notes = mesh.model.notes;
  SolverMesh& kept = outline.model.mesh;
  kept.map.spaces = whole.map.spaces;
  kept.map.spaceOf = whole.map.spaceOf;
  kept.number = whole.number;
  if (!whole.slab)
  {
    return outline;
  }
  kept.map.components = whole.map.components;
  kept.map.Allocate();
  std::ranges::copy(whole.map.coefficients, kept.map.coefficients.begin());
  kept.centre = whole.centre;
  kept.size = whole.size;
  kept.uncertainty = whole.uncertainty;
  kept.corners = whole.corners;
  kept.attribute = whole.attribute;
  kept.boundary = whole.boundary;
  kept.groups = whole.groups;
  kept.slab = whole.slab;
  return outline;
}

SolverModel Read(const std::vector<NamedText>& sessions, const std::vector<NamedText>& fieldParts)
{
  SessionMesh mesh = ReadMesh(sessions);
  if (fieldParts.empty())
  {
    RequireFields(mesh);
  }
  else
  {
    AddFields(fieldParts, mesh);
  }
  return std::move(mesh.model);
}
} // namespace pixelexact::nektar
