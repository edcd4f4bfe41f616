// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/ModelBuilder.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/FunctionSpace.h"
#include "Formats/MFEM/Meshes/MeshFile.h"
#include "Formats/MFEM/Text/QuadratureFile.h"

#include <algorithm>
#include <deque>

namespace pixelexact::mfem
{
namespace
{
using Bases = std::vector<const ElementBasis*>;

/// Whether elements share unknowns on edges or faces.
bool HasShared(const Collection& collection)
{
  return collection.Unknowns(Geometry::Segment) > 0 ||
    collection.Unknowns(Geometry::Triangle) > 0 || collection.Unknowns(Geometry::Square) > 0;
}

/// Whether values of ghost cells follow those of the elements, as PETSc's GLVis viewer writes
/// finite volumes: at most one for each face of the border.
bool HasGhostValues(const GridFunctionFile& file, const FunctionSpace& space,
  const Collection& collection, const MeshFile& mesh, int borderFaces)
{
  const auto values = static_cast<std::int64_t>(file.values.size());
  const std::int64_t ghosts = values / file.components - space.Size();
  return collection.GetContinuity() == Continuity::L2 &&
    space.Size() == std::ssize(mesh.elements) && values % file.components == 0 &&
    (!file.byNodes || file.components == 1) && ghosts > 0 && ghosts <= borderFaces;
}

/// Checks the number of values before bases are made: a damaged name may request order 32.
void RequireValues(const GridFunctionFile& file, const FunctionSpace& space,
  const std::string& where, const MeshFile& mesh)
{
  const std::int64_t expected = space.Size() * file.components;
  if (static_cast<std::int64_t>(file.values.size()) != expected)
  {
    throw InvalidData(where + " holds " + Counted(file.values.size(), "value") + ", but " +
      file.collection + " with VDim " + std::to_string(file.components) + " on this mesh of " +
      Counted(mesh.elements.size(), "element") + " has " + std::to_string(expected) +
      "; the file is cut short, or belongs to another mesh or to another piece of it.");
  }
}

Collection ParseCollection(const std::string& name, int dimension, const std::string& where)
{
  return NameErrors(where, [&] { return Collection::Parse(name, dimension); });
}

/// Unused entries of cell.vertices are zero. `first`: of the piece's vertices.
Corners CornersOf(const Cell& cell, std::int64_t first)
{
  Corners corners{};
  const int vertices = TableOf(cell.geometry).vertices;
  for (int k = 0; k < vertices; ++k)
  {
    corners[k] = first + cell.vertices[k];
  }
  if (IsOfDimension(cell.geometry, 2))
  {
    // Copies the corners below the slab to those above.
    std::copy_n(corners.begin(), vertices, corners.begin() + vertices);
  }
  return corners;
}

/// The linear map of a mesh without nodes.
GridFunctionFile LinearNodes(MeshFile& mesh)
{
  return { "Linear", 3, false, std::move(mesh.coordinates), std::nullopt };
}
} // namespace

ModelBuilder::ModelBuilder(std::vector<MeshPiece> pieces)
  : Pieces(std::move(pieces))
{
  for (std::size_t p = 0; p < Pieces.size(); ++p)
  {
    const MeshFile& file = Pieces[p].file;
    if (file.dimension != Pieces[0].file.dimension)
    {
      throw InvalidData(Pieces[p].name + ": its elements are " + std::to_string(file.dimension) +
        "-D, those of " + Pieces[0].name + " " + std::to_string(Pieces[0].file.dimension) +
        "-D; the two are no pieces of one mesh.");
    }
    Entities.emplace_back();
  }
  const bool isJoined = Pieces[0].file.nurbs && !Pieces[0].file.nurbs->pieces.empty();
  if (isJoined)
  {
    Joined = JoinNurbs(Pieces);
  }
  for (std::size_t p = 0; p < Pieces.size(); ++p)
  {
    for (std::size_t e = 0; e < Pieces[p].file.elements.size(); ++e)
    {
      Places.push_back({ static_cast<std::int32_t>(p), static_cast<std::int32_t>(e) });
    }
  }
  if (Places.empty())
  {
    throw InvalidData(
      Pieces.front().name + ": the mesh has no elements; there is nothing to show.");
  }
  if (Pieces[0].file.nurbs)
  {
    AddNurbs(isJoined);
  }
  AddMap();
  AddGroups();
  for (auto& entities : Entities)
  {
    if (entities)
    {
      entities->ForgetVertices();
    }
  }
}

void ModelBuilder::AddNurbs(bool isJoined)
{
  if (isJoined)
  {
    // Elements of the whole mesh, in its order.
    std::vector<Place> ordered(Places.size());
    for (const Place& place : Places)
    {
      const auto& own = Joined.nurbs->pieces[static_cast<std::size_t>(place.piece)];
      ordered[static_cast<std::size_t>(own[static_cast<std::size_t>(place.element)])] = place;
    }
    Places = std::move(ordered);
  }
  else if (Pieces.size() > 1)
  {
    throw InvalidData(Pieces[0].name + " is a whole NURBS mesh, and " + Pieces[1].name +
      " beside it is no piece of it; give it a name without a number.");
  }
  std::vector<GridFunctionFile> nodes;
  std::vector<std::string> names;
  for (MeshPiece& piece : Pieces)
  {
    names.push_back(piece.name);
    if (piece.file.nodes->IsNurbs())
    {
      nodes.push_back(std::move(*piece.file.nodes));
      piece.file.nodes.reset();
    }
  }
  if (!nodes.empty() && nodes.size() < Pieces.size())
  {
    throw InvalidData(names.front() +
      ": some pieces of the mesh have NURBS nodes, and others have "
      "not; they are of different runs.");
  }
  Nurbs = std::make_unique<NurbsModel>(isJoined ? Joined : Pieces[0].file, nodes, names);
}

const MeshFile& ModelBuilder::ShownOf(std::size_t piece) const
{
  return Nurbs ? Nurbs->Shown() : Pieces[piece].file;
}

/// A grid function of all pieces, ready to be assembled.
struct ModelBuilder::Source
{
  Source(ModelBuilder& builder, const std::vector<GridFunctionFile>& files,
    const std::vector<std::string>& names);
  Source(const Source&) = delete; // the spaces refer to the collection
  Source& operator=(const Source&) = delete;

  Collection collection;
  std::deque<FunctionSpace> spaces; ///< per piece
  std::vector<const ElementBasis*> bases;
};

ModelBuilder::Source::Source(ModelBuilder& builder, const std::vector<GridFunctionFile>& files,
  const std::vector<std::string>& names)
  : collection(ParseCollection(CollectionOf(files[0], builder.Pieces[0].file.dimension),
      builder.Pieces[0].file.dimension, names[0]))
{
  for (std::size_t p = 0; p < files.size(); ++p)
  {
    if (files[p].collection != files[0].collection || files[p].components != files[0].components)
    {
      throw InvalidData(names[p] + " and " + names[0] + " are of different spaces (" +
        files[p].collection + " with VDim " + std::to_string(files[p].components) + ", " +
        files[0].collection + " with VDim " + std::to_string(files[0].components) +
        "); they are no pieces of one grid function.");
    }
    const MeshFile& mesh = builder.Pieces[p].file;
    const auto isTensor = [](const Cell& cell)
    { return cell.geometry == Geometry::Square || cell.geometry == Geometry::Cube; };
    RequirePoints(
      files[p], !builder.Nurbs && std::ranges::all_of(mesh.elements, isTensor), names[p]);
    static const Topology nothing;
    spaces.emplace_back(mesh, HasShared(collection) ? builder.EntitiesOf(p) : nothing, collection);
    const auto values = static_cast<std::int64_t>(files[p].values.size());
    if (values > spaces.back().Size() * files[p].components &&
      HasGhostValues(
        files[p], spaces.back(), collection, mesh, builder.EntitiesOf(p).BorderFaces()))
    {
      builder.Model.notes.push_back(names[p] + ": of " +
        std::to_string(values / files[p].components) + " values the first " +
        std::to_string(mesh.elements.size()) +
        ", one for each element, are read; the others are those of ghost cells beyond the border, "
        "which PETSc writes after them.");
      continue;
    }
    RequireValues(files[p], spaces.back(), names[p], mesh);
  }
  for (const auto& [piece, element] : builder.Places)
  {
    const Geometry geometry = builder.Pieces[piece].file.elements[element].geometry;
    bases.push_back(NameErrors(names[0], [&] { return &collection.Basis(geometry); }));
  }
}

const Topology& ModelBuilder::EntitiesOf(std::size_t p)
{
  auto& entities = Entities[p];
  return entities ? *entities : entities.emplace(Pieces[p].file);
}

std::int64_t ModelBuilder::ElementsOf(std::int32_t piece) const
{
  return std::ranges::count(Places, piece, &Place::piece);
}

void ModelBuilder::AddMap()
{
  if (Nurbs && Nurbs->HasMap())
  {
    Nurbs->AddMap(Model);
    return;
  }
  std::vector<GridFunctionFile> nodes;
  std::vector<std::string> names;
  for (MeshPiece& piece : Pieces)
  {
    nodes.push_back(piece.file.nodes ? std::move(*piece.file.nodes) : LinearNodes(piece.file));
    piece.file.nodes.reset();
    names.push_back(piece.name + ": the mesh's nodes (" + nodes.back().collection + ")");
  }
  const int dimension = Pieces[0].file.dimension;
  const Source source(*this, nodes, names);
  const int components = nodes[0].components;
  if (source.collection.IsVector() || source.collection.GetMapping() != Mapping::Identity ||
    components < dimension || components > 3)
  {
    throw InvalidData(names[0] + " are no positions: they need an H1 or L2 collection with VDim " +
      (dimension == 2 ? "2 or 3." : "3."));
  }
  const auto gather = [&](std::size_t e, std::span<double> values)
  {
    const auto [piece, element] = Places[e];
    source.spaces[piece].Gather(
      element, nodes[piece].values, components, nodes[piece].byNodes, values);
  };
  const auto describe = [&](std::size_t e)
  { return Pieces[Places[e].piece].name + ": element " + std::to_string(Places[e].element); };
  if (dimension == 3)
  {
    AssembleMap(source.bases, gather, describe, Model.mesh);
    return;
  }
  AssemblePlaneMap(source.bases, components, gather, describe, Model.mesh);
}

void ModelBuilder::AddGroups()
{
  SolverMesh& mesh = Model.mesh;
  std::vector<std::int64_t> firstVertex{ 0 };
  for (const MeshPiece& piece : Pieces)
  {
    firstVertex.push_back(firstVertex.back() + piece.file.vertices);
  }
  std::int32_t firstElement = 0;
  for (std::size_t p = 0; p < (Nurbs ? 1 : Pieces.size()); ++p)
  {
    const MeshFile& shown = ShownOf(p);
    for (std::size_t e = 0; e < shown.elements.size(); ++e)
    {
      const Cell& cell = shown.elements[e];
      mesh.number.push_back(
        Nurbs ? Nurbs->Parts()[e].element : firstElement + static_cast<std::int64_t>(e));
      mesh.corners.push_back(CornersOf(cell, firstVertex[p]));
      mesh.attribute.push_back(cell.attribute);
    }
    AddBoundary(p, firstElement);
    firstElement += static_cast<std::int32_t>(shown.elements.size());
    for (Group& group : Pieces[p].file.groups)
    {
      const bool known = std::ranges::any_of(mesh.groups,
        [&](const Group& other) {
          return other.id == group.id && other.name == group.name &&
            other.boundary == group.boundary;
        });
      if (!known)
      {
        mesh.groups.push_back(std::move(group));
      }
    }
  }
}

void ModelBuilder::AddBoundary(std::size_t p, std::int32_t firstElement)
{
  const MeshFile& file = ShownOf(p);
  const std::string& name = Pieces[p].name;
  if (file.boundary.empty())
  {
    return;
  }
  const Topology& entities = Nurbs ? Nurbs->Entities() : EntitiesOf(p);
  std::size_t ownerless = 0;
  for (const Cell& cell : file.boundary)
  {
    const auto owners =
      entities.FindFace(std::span(cell.vertices).first(TableOf(cell.geometry).vertices));
    ownerless += owners.empty() ? 1 : 0;
    for (const auto& owner : owners)
    {
      const GeometryTable& table = TableOf(file.elements[owner.element].geometry);
      Model.mesh.boundary.push_back({ firstElement + owner.element,
        table.sides.empty() ? table.faces[owner.localFace].vtkFace : table.sides[owner.localFace],
        cell.attribute });
    }
  }
  if (ownerless > 0)
  {
    Model.notes.push_back(name + ": " + std::to_string(ownerless) + " of " +
      Counted(file.boundary.size(), "boundary element") + " are no face of an element.");
  }
}

/// An INLINE mesh has no numbers of MFEM's.
void ModelBuilder::RequireNumbers(const std::string& name) const
{
  for (const MeshPiece& piece : Pieces)
  {
    if (!piece.file.isNumbered)
    {
      throw Unsupported(name + ": grid functions on INLINE meshes (" + piece.name +
        ") are not read: MFEM numbers their elements along a curve of its own; save the mesh "
        "(Mesh::Save) and read it with that.");
    }
  }
}

void ModelBuilder::AddField(const std::vector<GridFunctionFile>& files,
  const std::vector<std::string>& names, const std::string& name)
{
  RequireNumbers(names[0]);
  if (files[0].IsNurbs() && Nurbs)
  {
    Nurbs->AddField(files, names, name, Model);
    return;
  }
  const Source source(*this, files, names);
  const Collection& collection = source.collection;
  if (collection.IsVector() && files[0].components != 1)
  {
    throw Unsupported(names[0] + ": " + files[0].collection + " with VDim " +
      std::to_string(files[0].components) +
      " (several vector fields in one) is not read; save them one by one.");
  }
  SolverField field;
  field.name = name;
  field.mapping = collection.GetMapping();
  field.basis = collection.Description();
  field.continuous = collection.GetContinuity() == Continuity::H1;
  const int components = files[0].components;
  field.values = AssembleField(source.bases, collection.IsVector() ? 3 : components,
    [&](std::size_t e, std::span<double> values)
    {
      const auto [piece, element] = Places[e];
      source.spaces[piece].Gather(
        element, files[piece].values, components, files[piece].byNodes, values);
    });
  if (Nurbs)
  {
    field.values = rational::RestrictToParts(field.values, field.mapping, Nurbs->Parts());
  }
  if (Model.mesh.slab)
  {
    ScaleToSlab(*Model.mesh.slab, field);
  }
  Model.fields.push_back(std::move(field));
}
} // namespace pixelexact::mfem
