// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/MeshFile.h"

#include "Formats/MFEM/Meshes/RefinementTree.h"

#include <algorithm>
#include <array>

namespace pixelexact::mfem
{
namespace
{
constexpr std::size_t kShortestCell = 6; ///< "1 1 0 1" at a line's end

/// The sections before the vertices that were read.
struct Sections
{
  bool dimension = false;
  bool elements = false;
  bool vertices = false;
};

std::vector<Cell> ReadCells(TextScanner& scanner, const char* what, int dimension)
{
  // Each further dimension adds at least one vertex to a cell.
  const int count =
    scanner.Count(what, kShortestCell + 2 * static_cast<std::size_t>(dimension - 1));
  std::vector<Cell> cells;
  cells.reserve(count);
  for (int i = 0; i < count; ++i)
  {
    cells.push_back(ReadCell(scanner, kMaxVertices, dimension));
  }
  return cells;
}

/// Reads named lists of attributes (version 1.3).
void ReadAttributeSets(TextScanner& scanner, bool boundary, std::vector<Group>& groups)
{
  const int sets = scanner.Count("the number of attribute sets", 4);
  for (int i = 0; i < sets; ++i)
  {
    const std::string name = scanner.QuotedWord("the name of an attribute set");
    const int size = scanner.Count("the size of an attribute set", 2);
    for (int k = 0; k < size; ++k)
    {
      groups.push_back({ scanner.Integer("an attribute"), name, boundary });
    }
  }
}

/// Skips the tree of old non-conforming files. Their leaves and vertices are numbered in the order
/// of the file.
void SkipTree(TextScanner& scanner, std::string_view section)
{
  const int count = scanner.Count("the number of tree entries", 4);
  for (int i = 0; i < count; ++i)
  {
    int numbers = 3;
    if (section == "coarse_elements")
    {
      numbers = ChildrenOf(scanner.Integer("a refinement type", 0, 7));
    }
    for (int k = 0; k < numbers; ++k)
    {
      scanner.Integer("a number of the refinement tree");
    }
  }
}

void ReadVertices(TextScanner& scanner, MeshFile& mesh)
{
  mesh.vertices = scanner.Integer("the number of vertices", 0, kMaxVertices);
  if (scanner.Peek() == "nodes")
  {
    return;
  }
  const int space = ReadSpaceDimension(scanner, mesh.dimension);
  scanner.Positions(mesh.vertices, space, mesh.coordinates);
}

/// Reads the processes with which a piece shares entities. Each piece keeps its own unknowns, so
/// nothing else of these sections is used.
std::set<int> ReadSharing(TextScanner& scanner)
{
  scanner.Expect("number_of_groups");
  const int groups = scanner.Count("the number of groups", 2);
  std::set<int> processes;
  for (int g = 0; g < groups; ++g)
  {
    const int size = scanner.Count("the size of a group", 2);
    for (int k = 0; k < size; ++k)
    {
      processes.insert(scanner.Integer("a process", 0, kMaxVertices));
    }
  }
  while (!scanner.Peek().empty() && scanner.Peek() != "mfem_mesh_end")
  {
    if (double number = 0.0; scanner.TryNumber(number))
    {
      continue;
    }
    const std::string_view word = scanner.Peek();
    if (!word.starts_with("total_shared_") && !word.starts_with("shared_"))
    {
      scanner.FailAtWord("among the vertices, edges and faces that processes share");
    }
    scanner.Word("what processes share");
  }
  if (!scanner.Peek().empty())
  {
    scanner.Word("the end of the mesh");
  }
  return processes;
}

/// Reads one section. Returns false where the next word does not begin a section of a mesh.
bool ReadSection(TextScanner& scanner, MeshFile& mesh, Sections& seen)
{
  const std::string_view section = scanner.Peek();
  if (seen.vertices && section != "nodes" && section != "communication_groups" &&
    section != "mfem_mesh_end" && section != "mfem_serial_mesh_end")
  {
    return false;
  }
  scanner.Word("a section of the mesh");
  if (section == "dimension")
  {
    mesh.dimension = ReadDimension(scanner);
    seen.dimension = true;
  }
  else if (!seen.dimension)
  {
    scanner.Fail("the mesh does not begin with its section 'dimension'.");
  }
  else if (section == "elements")
  {
    mesh.elements = ReadCells(scanner, "the number of elements", mesh.dimension);
    seen.elements = true;
  }
  else if (section == "boundary")
  {
    mesh.boundary = ReadCells(scanner, "the number of boundary elements", mesh.dimension - 1);
  }
  else if (section == "attribute_sets" || section == "bdr_attribute_sets")
  {
    ReadAttributeSets(scanner, section == "bdr_attribute_sets", mesh.groups);
  }
  else if (section == "vertex_parents" || section == "coarse_elements")
  {
    SkipTree(scanner, section);
  }
  else if (section == "vertices")
  {
    ReadVertices(scanner, mesh);
    seen.vertices = true;
  }
  else if (section == "nodes" && seen.vertices)
  {
    mesh.nodes = ReadGridFunction(scanner);
  }
  else if (section == "mfem_mesh_end" && seen.vertices)
  {
    return false;
  }
  else if (section == "mfem_serial_mesh_end" && seen.vertices)
  {
    return true; // what processes share follows
  }
  else if (section == "communication_groups")
  {
    mesh.sharing = ReadSharing(scanner);
    mesh.ranks = mesh.sharing.empty() ? 1 : *mesh.sharing.rbegin() + 1;
    return false;
  }
  else
  {
    scanner.Fail("'" + std::string(section.substr(0, 40)) +
      "' is no section of a mesh; the file is damaged or of another format.");
  }
  return true;
}

void CheckVertices(TextScanner& scanner, const MeshFile& mesh)
{
  for (const auto* cells : { &mesh.elements, &mesh.boundary })
  {
    for (std::size_t i = 0; i < cells->size(); ++i)
    {
      const Cell& cell = (*cells)[i];
      const auto vertices = std::span(cell.vertices).first(TableOf(cell.geometry).vertices);
      const int largest = std::ranges::max(vertices);
      if (largest >= mesh.vertices)
      {
        scanner.Fail(std::string(cells == &mesh.elements ? "element " : "boundary element ") +
          std::to_string(i) + " has the vertex " + std::to_string(largest) +
          ", but the mesh has only " + std::to_string(mesh.vertices) +
          " of them; the file contradicts itself.");
      }
    }
  }
}

/// Removes vertices that no element has and renumbers the others, as MFEM does.
void RemoveUnusedVertices(MeshFile& mesh)
{
  std::vector<int> number;
  for (const Cell& cell : mesh.elements)
  {
    const auto vertices = std::span(cell.vertices).first(TableOf(cell.geometry).vertices);
    number.insert(number.end(), vertices.begin(), vertices.end());
  }
  std::ranges::sort(number);
  number.erase(std::unique(number.begin(), number.end()), number.end());
  if (static_cast<int>(number.size()) == mesh.vertices)
  {
    return;
  }
  const auto renumber = [&](Cell& cell)
  {
    for (int& v : std::span(cell.vertices).first(TableOf(cell.geometry).vertices))
    {
      v = static_cast<int>(std::ranges::lower_bound(number, v) - number.begin());
    }
  };
  // Boundary elements with a removed vertex are dropped.
  std::erase_if(mesh.boundary,
    [&](const Cell& cell)
    {
      return !std::ranges::all_of(std::span(cell.vertices).first(TableOf(cell.geometry).vertices),
        [&](int v) { return std::ranges::binary_search(number, v); });
    });
  std::ranges::for_each(mesh.elements, renumber);
  std::ranges::for_each(mesh.boundary, renumber);
  for (std::size_t i = 0; i < number.size() && !mesh.coordinates.empty(); ++i)
  {
    std::copy_n(
      &mesh.coordinates[3 * static_cast<std::size_t>(number[i])], 3, &mesh.coordinates[3 * i]);
  }
  mesh.coordinates.resize(std::min(mesh.coordinates.size(), 3 * number.size()));
  mesh.vertices = static_cast<int>(number.size());
}
} // namespace

MeshFile ReadConforming(TextScanner& scanner, bool legacy)
{
  MeshFile mesh;
  Sections seen;
  while (!(seen.vertices && scanner.Peek().empty()) && ReadSection(scanner, mesh, seen))
  {
  }
  if (!seen.dimension || !seen.elements || !seen.vertices)
  {
    scanner.Fail("the mesh lacks its section 'dimension', 'elements' or 'vertices'.");
  }
  CheckVertices(scanner, mesh);
  if (!legacy)
  {
    RemoveUnusedVertices(mesh);
  }
  return mesh;
}
} // namespace pixelexact::mfem
