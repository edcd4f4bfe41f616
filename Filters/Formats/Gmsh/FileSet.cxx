// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/FileSet.h"

#include "Core/Base/Error.h"
#include "Formats/Gmsh/MeshSections.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace pixelexact::gmsh
{
namespace
{
/// They say nothing of geometry or fields: which nodes a periodic model identifies, copies for
/// parallel solvers, numbers of edges and faces, the model's own surfaces.
constexpr std::array kPassed{ "Comments", "Periodic", "GhostElements", "Edges", "Faces",
  "Parametrizations" };
constexpr std::array kMeshSections{ "Nodes", "ParametricNodes", "Elements", "Entities",
  "PartitionedEntities", "PhysicalNames" };

template <class List>
bool Holds(const List& list, const std::string& name)
{
  return std::ranges::find(list, name) != list.end();
}

/// The file's name without folder and suffixes.
std::string Stem(const std::string& path)
{
  std::filesystem::path file = std::filesystem::path(path).filename();
  if (file.extension() == ".gz")
  {
    file = file.stem();
  }
  return file.stem().string();
}

const Section* Find(Scanner& scanner, const std::vector<Section>& sections, const std::string& name)
{
  const auto found = std::ranges::find(sections, name, &Section::name);
  if (found == sections.end())
  {
    return nullptr;
  }
  scanner.MoveTo(found->begin);
  if (std::find_if(found + 1, sections.end(), [&](const auto& s) { return s.name == name; }) !=
    sections.end())
  {
    scanner.Fail(
      "there are two sections $" + name + "; one mesh is read, so write a file for each.");
  }
  return &*found;
}
} // namespace

FileSet::FileSet(const std::vector<NamedText>& files, std::size_t pieces)
  : Pieces(pieces)
{
  for (std::size_t file = 0; file < files.size(); ++file)
  {
    Scanners.emplace_back(files[file].name, files[file].text, files[file].file);
    Sections.push_back(ListSections(Scanners.back()));
    ReadViews(file);
  }
}

void FileSet::ReadViews(std::size_t file)
{
  Scanner& scanner = Scanners[file];
  for (const Section& section : Sections[file])
  {
    scanner.MoveTo(section.begin);
    if (const auto kind = KindOf(section.name))
    {
      Views.AddHead(scanner, file, Pieces, *kind, Stem(scanner.Name()));
    }
    else if (section.name == "InterpolationScheme")
    {
      Views.AddScheme(scanner);
    }
    else
    {
      Pass(section, file);
    }
  }
}

/// What holds no view.
void FileSet::Pass(const Section& section, std::size_t file)
{
  if (Holds(kMeshSections, section.name))
  {
    if (file >= Pieces && (section.name == "Nodes" || section.name == "Elements"))
    {
      Scanners[file].Fail("it has a mesh of its own; name it alone, or write the views without the "
                          "mesh (PostProcessing.SaveMesh = 0).");
    }
    return;
  }
  if (section.name == "GaussPointData")
  {
    Notes.push_back(Scanners[file].Name() +
      ": values at integration points ($GaussPointData) are no polynomial and are left out.");
  }
  else if (!Holds(kPassed, section.name))
  {
    Notes.push_back(Scanners[file].Name() + ": the section $" + section.name.substr(0, 40) +
      " is not known here and was passed over.");
  }
}

MeshFile FileSet::ReadMesh()
{
  if (Pieces == 1)
  {
    return ReadPiece(0);
  }
  MeshUnion whole;
  for (std::size_t file = 0; file < Pieces; ++file)
  {
    whole.Add(ReadPiece(file), Scanners[file].Name());
  }
  return whole.Finish();
}

Partitions FileSet::ReadPartitions()
{
  Scanner& scanner = Scanners.front();
  MeshFile mesh;
  if (Find(scanner, Sections.front(), "PartitionedEntities") != nullptr)
  {
    Entities entities;
    ReadEntities(scanner, true, entities, mesh);
    return { mesh.partitions, mesh.partitionsHere };
  }
  // Version 2.2 tells of its elements alone.
  mesh = ReadPiece(0);
  return { mesh.partitionsHere.empty() ? 1U : 0U, mesh.partitionsHere };
}

MeshFile FileSet::ReadPiece(std::size_t file)
{
  MeshFile mesh;
  Entities entities;
  Scanner& scanner = Scanners[file];
  const auto& sections = Sections[file];
  if (Find(scanner, sections, "PhysicalNames") != nullptr)
  {
    ReadPhysicalNames(scanner, mesh);
  }
  for (const bool partitioned : { false, true })
  {
    const char* name = partitioned ? "PartitionedEntities" : "Entities";
    if (Find(scanner, sections, name) != nullptr)
    {
      ReadEntities(scanner, partitioned, entities, mesh);
    }
  }
  const bool parametric = Find(scanner, sections, "ParametricNodes") != nullptr;
  if (!parametric && Find(scanner, sections, "Nodes") == nullptr)
  {
    throw InvalidData(scanner.Name() +
      ": the file has no $Nodes, so no mesh; name the file of its mesh before it.");
  }
  ReadNodes(scanner, parametric, mesh);
  if (Find(scanner, sections, "Elements") == nullptr)
  {
    throw InvalidData(
      scanner.Name() + ": the file has nodes, but no $Elements; there is nothing to show.");
  }
  const std::size_t elements = scanner.Position();
  ReadElements(scanner, entities, mesh);
  if (mesh.elements.empty() && !mesh.faces.empty())
  {
    mesh.dimension = 2;
    mesh.faces.clear();
    mesh.elementOf = {};
    mesh.lower = 0;
    scanner.MoveTo(elements);
    ReadElements(scanner, entities, mesh);
  }
  return mesh;
}
} // namespace pixelexact::gmsh
