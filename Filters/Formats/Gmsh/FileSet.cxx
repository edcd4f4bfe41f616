// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/FileSet.h"

#include "Core/Base/Error.h"
#include "Core/Base/Quote.h"
#include "Formats/Gmsh/MeshFile.h"
#include "Formats/Gmsh/Scanner.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pixelexact::gmsh
{
namespace
{
constexpr const char* kFormat = "MeshFormat";
constexpr std::array kOld{ 2.0, 2.1, 2.2 };

void ReadEncoding(Scanner& scanner)
{
  Encoding encoding;
  encoding.version = scanner.TextNumber("the version");
  const auto mode = scanner.TextInteger("the file type");
  const auto bytes = scanner.TextInteger("the data size");
  const bool isOld = std::ranges::find(kOld, encoding.version) != kOld.end();
  if (!isOld && encoding.version != kNew)
  {
    scanner.FailUnsupported("version " + std::to_string(encoding.version).substr(0, 3) +
      " of the format is not read, 2.0 to 2.2 and 4.1 are; convert it: gmsh FILE.msh -save -format "
      "msh41 "
      "-o NEW.msh.");
  }
  if (mode != 0 && mode != 1)
  {
    scanner.Fail("the file type is " + std::to_string(mode) + ", not 0 (text) or 1 (binary).");
  }
  // The data size is that of doubles in versions 2 and that of counts in 4.1.
  if (bytes != 8 && !(bytes == 4 && encoding.version == kNew))
  {
    scanner.Fail("the data size is " + std::to_string(bytes) + " bytes, not 8.");
  }
  encoding.sizeBytes = static_cast<int>(bytes);
  encoding.binary = mode == 1;
  scanner.SetEncoding(encoding);
  if (encoding.binary)
  {
    constexpr int kSwappedOne = 1 << 24;
    scanner.EndLine();
    const int one = scanner.Int("the number one");
    if (one != 1 && one != kSwappedOne)
    {
      scanner.Fail("the number one that shows the byte order is " + std::to_string(one) +
        "; the file is damaged.");
    }
    encoding.swapped = one == kSwappedOne;
    scanner.SetEncoding(encoding);
  }
  scanner.EndSection(kFormat);
}

/// Lists the sections of a file, in its order, without $MeshFormat, which sets the scanner's
/// encoding. Throws InvalidData where the file is not a Gmsh file, Unsupported for versions other
/// than 2.0 to 2.2 and 4.1.
std::vector<Section> ListSections(Scanner& scanner)
{
  if (!scanner.Peek().starts_with('$'))
  {
    scanner.Fail("found " + Quote(scanner.Peek()) +
      " where a Gmsh file begins with '$MeshFormat'; it is a file of another program.");
  }
  std::vector<Section> sections;
  bool known = false;
  while (!scanner.Peek().empty())
  {
    const std::string_view word = scanner.Word("a section");
    if (!word.starts_with('$'))
    {
      scanner.Fail("found " + Quote(word) +
        " behind the end of a section; the file is damaged, or a section has a wrong end.");
    }
    Section section{ std::string(word.substr(1)), 0 };
    scanner.EndLine();
    section.begin = scanner.Position();
    if (section.name == kFormat)
    {
      ReadEncoding(scanner);
      known = true;
      continue;
    }
    if (!known && section.name != "Comments")
    {
      scanner.FailUnsupported("$" + section.name.substr(0, 40) +
        " stands before $MeshFormat: this is version 1 of the format or no Gmsh file; convert it: "
        "gmsh FILE.msh -save -format msh41 -o NEW.msh.");
    }
    scanner.LeaveSection(section.name);
    sections.push_back(std::move(section));
  }
  return sections;
}

/// Sections that are skipped, because they contain neither geometry nor fields: which nodes a
/// periodic model identifies, copies for parallel solvers, numbers of edges and faces, the model's
/// own surfaces.
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

/// Handles a section that holds no view: fails for a second mesh, notes unknown sections.
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

MeshFile FileSet::ReadMesh(bool surfaces)
{
  if (Pieces == 1)
  {
    return ReadPiece(0, surfaces);
  }
  MeshUnion whole;
  for (std::size_t file = 0; file < Pieces; ++file)
  {
    whole.Add(ReadPiece(file, surfaces), Scanners[file].Name());
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
  // In version 2.2 only the elements name their partition.
  mesh = ReadPiece(0);
  return { mesh.partitionsHere.empty() ? 1U : 0U, mesh.partitionsHere };
}

MeshFile FileSet::ReadPiece(std::size_t file, bool surfaces)
{
  MeshFile mesh;
  mesh.dimension = surfaces ? 2 : 3;
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
  if (mesh.elements.empty() && !mesh.faces.empty() && !surfaces)
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
