// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Reader.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/FunctionSpace.h"
#include "Formats/MFEM/GeometryTable.h"
#include "Formats/MFEM/MeshFormat.h"
#include "Formats/MFEM/StreamCommands.h"

#include <algorithm>
#include <filesystem>

namespace pixelexact::mfem
{
namespace
{
using Bases = std::vector<const ElementBasis*>;

Bases BasesOf(const MeshFile& mesh, const Collection& collection, const std::string& where)
{
  Bases bases;
  bases.reserve(mesh.elements.size());
  try
  {
    for (const Cell& cell : mesh.elements)
    {
      bases.push_back(&collection.Basis(cell.geometry));
    }
  }
  catch (const Unsupported& error)
  {
    throw Unsupported(where + ": " + error.what());
  }
  return bases;
}

/// Bases are made only when the values are known to fit: a damaged name may ask for order 32.
void RequireValues(const GridFunctionFile& file, const FunctionSpace& space,
  const std::string& where, const MeshFile& mesh)
{
  const std::int64_t expected = space.Size() * file.components;
  if (static_cast<std::int64_t>(file.values.size()) != expected)
  {
    throw InvalidData(where + " holds " + Counted(file.values.size(), "value") + ", but " +
      file.collection + " with VDim " + std::to_string(file.components) + " on this mesh of " +
      Counted(mesh.elements.size(), "element") + " has " + std::to_string(expected) +
      "; the file is cut short, holds one piece of a parallel one (save it with SaveAsOne) or "
      "belongs "
      "to another mesh.");
  }
}

Collection ParseCollection(const std::string& name, int dimension, const std::string& where)
{
  try
  {
    return Collection::Parse(name, dimension);
  }
  catch (const Unsupported& error)
  {
    throw Unsupported(where + ": " + error.what());
  }
  catch (const InvalidData& error)
  {
    throw InvalidData(where + ": " + error.what());
  }
}

/// Unused entries of cell.vertices are zero.
Corners CornersOf(const Cell& cell)
{
  Corners corners{};
  std::ranges::copy(cell.vertices, corners.begin());
  if (IsOfDimension(cell.geometry, 2))
  {
    // Those of the slab below and above.
    const int vertices = TableOf(cell.geometry).vertices;
    std::copy_n(cell.vertices.begin(), vertices, corners.begin() + vertices);
  }
  return corners;
}

/// The linear map of a mesh without nodes.
GridFunctionFile LinearNodes(MeshFile& mesh)
{
  return { "Linear", 3, false, std::move(mesh.coordinates) };
}

class ModelBuilder
{
public:
  ModelBuilder(MeshFile mesh, std::string meshName)
    : File(std::move(mesh))
    , MeshName(std::move(meshName))
    , Entities(File)
  {
    if (File.elements.empty())
    {
      throw InvalidData(MeshName + ": the mesh has no elements; there is nothing to show.");
    }
    AddMap();
    AddGroups();
  }

  void AddField(const GridFunctionFile& file, const std::string& where, const std::string& name);

  SolverModel Model;

private:
  void AddMap();
  void AddGroups();

  MeshFile File;
  std::string MeshName;
  Topology Entities;
};

void ModelBuilder::AddMap()
{
  const GridFunctionFile nodes = File.nodes ? std::move(*File.nodes) : LinearNodes(File);
  File.nodes.reset();
  const std::string where = MeshName + ": the mesh's nodes (" + nodes.collection + ")";
  const Collection collection = ParseCollection(nodes.collection, File.dimension, MeshName);
  if (collection.IsVector() || collection.GetMapping() != Mapping::Identity ||
    nodes.components < File.dimension || nodes.components > 3)
  {
    throw InvalidData(where + " are no positions: they need an H1 or L2 collection with VDim " +
      (File.dimension == 2 ? "2 or 3." : "3."));
  }
  const FunctionSpace space(File, Entities, collection);
  RequireValues(nodes, space, where, File);
  const Bases bases = BasesOf(File, collection, MeshName);
  const auto gather = [&](std::size_t e, std::span<double> source)
  { space.Gather(e, nodes.values, nodes.components, nodes.byNodes, source); };
  const auto describe = [&](std::size_t e) { return MeshName + ": element " + std::to_string(e); };
  if (File.dimension == 3)
  {
    AssembleMap(bases, gather, describe, Model.mesh);
    return;
  }
  try
  {
    AssemblePlaneMap(bases, nodes.components, gather, describe, Model.mesh);
  }
  catch (const Unsupported& error)
  {
    throw Unsupported(MeshName + ": " + error.what());
  }
}

void ModelBuilder::AddGroups()
{
  SolverMesh& mesh = Model.mesh;
  for (std::size_t e = 0; e < File.elements.size(); ++e)
  {
    mesh.number.push_back(static_cast<std::int64_t>(e));
    mesh.corners.push_back(CornersOf(File.elements[e]));
    mesh.attribute.push_back(File.elements[e].attribute);
  }
  std::size_t ownerless = 0;
  for (const Cell& cell : File.boundary)
  {
    const auto owners =
      Entities.FindFace(std::span(cell.vertices).first(TableOf(cell.geometry).vertices));
    ownerless += owners.empty() ? 1 : 0;
    for (const auto& owner : owners)
    {
      const GeometryTable& table = TableOf(File.elements[owner.element].geometry);
      mesh.boundary.push_back({ owner.element,
        table.sides.empty() ? table.faces[owner.localFace].vtkFace : table.sides[owner.localFace],
        cell.attribute });
    }
  }
  if (ownerless > 0)
  {
    Model.notes.push_back(MeshName + ": " + std::to_string(ownerless) + " of " +
      Counted(File.boundary.size(), "boundary element") + " are no face of an element.");
  }
  mesh.groups = std::move(File.groups);
}

void ModelBuilder::AddField(
  const GridFunctionFile& file, const std::string& where, const std::string& name)
{
  const Collection collection = ParseCollection(file.collection, File.dimension, where);
  if (collection.IsVector() && file.components != 1)
  {
    throw Unsupported(where + ": " + file.collection + " with VDim " +
      std::to_string(file.components) +
      " (several vector fields in one) is not read; save them one by one.");
  }
  const FunctionSpace space(File, Entities, collection);
  RequireValues(file, space, where, File);
  const Bases bases = BasesOf(File, collection, where);
  SolverField field;
  field.name = name;
  field.mapping = collection.GetMapping();
  field.basis = collection.Description();
  field.continuous = collection.GetContinuity() == Continuity::H1;
  field.values = AssembleField(bases, collection.IsVector() ? 3 : file.components,
    [&](std::size_t e, std::span<double> source)
    { space.Gather(e, file.values, file.components, file.byNodes, source); });
  if (Model.mesh.slab)
  {
    ScaleToSlab(*Model.mesh.slab, field);
  }
  Model.fields.push_back(std::move(field));
}

/// "u" of "results/u.gf" and of "u.gf.gz".
std::string FieldName(const std::string& path)
{
  std::filesystem::path file = std::filesystem::path(path).filename();
  if (file.extension() == ".gz")
  {
    file = file.stem();
  }
  return file.stem().string();
}

MeshFile ParseMesh(const NamedText& text)
{
  TextScanner scanner(text);
  MeshFile mesh = ReadMesh(scanner);
  if (!scanner.Peek().empty())
  {
    scanner.FailAtWord("behind the end of the mesh");
  }
  return mesh;
}

GridFunctionFile ParseGridFunction(const NamedText& text)
{
  TextScanner scanner(text);
  GridFunctionFile file = ReadGridFunction(scanner);
  if (!scanner.Peek().empty())
  {
    scanner.FailAtWord("among the numbers behind the header");
  }
  return file;
}

/// What a parser makes of a file, whose text is gone before anything is assembled.
template <class Result>
Result LoadFile(const std::string& path, Result (*parse)(const NamedText&))
{
  const std::string text = ReadFileText(path);
  return parse({ path, text });
}
} // namespace

SolverModel Read(const NamedText& mesh, const std::vector<NamedText>& gridFunctions)
{
  ModelBuilder builder(ParseMesh(mesh), mesh.name);
  for (const NamedText& text : gridFunctions)
  {
    builder.AddField(ParseGridFunction(text), text.name, FieldName(text.name));
  }
  return std::move(builder.Model);
}

SolverModel ReadFiles(const std::string& mesh, const std::vector<std::string>& gridFunctions)
{
  ModelBuilder builder(LoadFile(mesh, &ParseMesh), mesh);
  if (const std::string other = OtherPiece(mesh); !other.empty())
  {
    builder.Model.notes.push_back(mesh +
      ": its name is that of one piece of a parallel mesh, and '" + other +
      "' of another; what is shown may not be the whole. Save the whole mesh " +
      "(ParMesh::PrintAsOne or SaveAsOne) and read that.");
  }
  for (const std::string& file : gridFunctions)
  {
    builder.AddField(LoadFile(file, &ParseGridFunction), file, FieldName(file));
  }
  return std::move(builder.Model);
}

SolverModel ReadStream(const NamedText& saved)
{
  TextScanner scanner(saved);
  const bool hasField = ReadStreamKeyword(scanner);
  ModelBuilder builder(ReadMesh(scanner), saved.name);
  if (scanner.Peek() == "mfem_mesh_end")
  {
    scanner.Word("the end of the mesh");
  }
  if (hasField)
  {
    builder.AddField(ReadGridFunction(scanner), saved.name, "solution");
  }
  SkipCommands(scanner);
  return std::move(builder.Model);
}
} // namespace pixelexact::mfem
