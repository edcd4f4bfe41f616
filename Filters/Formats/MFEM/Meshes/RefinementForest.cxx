// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/MeshFile.h"

#include "Formats/MFEM/Meshes/RefinementTree.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <vector>

namespace pixelexact::mfem
{
namespace
{
constexpr int kMaxNodes = 1 << 30;

/// The vertices ("nodes") of a refined mesh: those of the coarsest level have coordinates, others
/// lie on the line between two parents.
class VertexHierarchy
{
public:
  /// `scaled`: each has its place between its parents, otherwise it is halfway.
  void ReadParents(TextScanner& scanner, bool scaled);
  void ReadCoordinates(TextScanner& scanner, int dimension);

  [[nodiscard]] bool HasParents(int node) const { return ParentsOf.contains(node); }
  /// Fails, through the scanner, for a node without coordinates and parents.
  std::array<double, 3> Position(TextScanner& scanner, int node, int generation = 0);

private:
  struct Parents
  {
    int first = 0;
    int second = 0;
    double share = 0.5; ///< of the second one
  };
  std::unordered_map<int, Parents> ParentsOf;
  std::vector<double> Coordinates; ///< by node
  std::unordered_map<int, std::array<double, 3>> Known;
};

constexpr int kMaxGenerations = 64;

void VertexHierarchy::ReadParents(TextScanner& scanner, bool scaled)
{
  const int count = scanner.Count("the number of vertices with parents", 4);
  for (int i = 0; i < count; ++i)
  {
    const int node = scanner.Integer("a vertex", 0, kMaxNodes);
    Parents parents;
    parents.first = scanner.Integer("a parent", 0, kMaxNodes);
    parents.second = scanner.Integer("a parent", 0, kMaxNodes);
    if (scaled)
    {
      parents.share = scanner.Number("a vertex' place between its parents");
    }
    ParentsOf[node] = parents;
  }
}

void VertexHierarchy::ReadCoordinates(TextScanner& scanner, int dimension)
{
  const int count = scanner.Count("the number of vertices with coordinates", 2);
  if (count > 0)
  {
    const int space = ReadSpaceDimension(scanner, dimension);
    scanner.Positions(count, space, Coordinates);
  }
}

std::array<double, 3> VertexHierarchy::Position(TextScanner& scanner, int node, int generation)
{
  if (const auto known = Known.find(node); known != Known.end())
  {
    return known->second;
  }
  if (generation > kMaxGenerations)
  {
    scanner.Fail("vertex " + std::to_string(node) + " has more than " +
      std::to_string(kMaxGenerations) + " generations of parents; the file is damaged.");
  }
  std::array<double, 3> x{};
  const auto parents = ParentsOf.find(node);
  if (parents == ParentsOf.end())
  {
    if (3 * static_cast<std::size_t>(node) + 2 >= Coordinates.size())
    {
      scanner.Fail("vertex " + std::to_string(node) + " has neither coordinates nor parents.");
    }
    std::copy_n(&Coordinates[3 * static_cast<std::size_t>(node)], 3, x.begin());
  }
  else
  {
    const auto a = Position(scanner, parents->second.first, generation + 1);
    const auto b = Position(scanner, parents->second.second, generation + 1);
    const double share = parents->second.share;
    std::ranges::transform(
      a, b, x.begin(), [share](double p, double q) { return (1.0 - share) * p + share * q; });
  }
  Known.emplace(node, x);
  return x;
}

constexpr int kStates = 24;
constexpr int kPlaneStates = 8;
constexpr std::size_t kShortestElement = 4;

class Forest
{
public:
  explicit Forest(TextScanner& scanner, bool scaled)
    : Scanner(scanner)
    , Scaled(scaled)
  {
  }

  MeshFile Read();

private:
  void ReadHeader();
  void ReadElement(int index, int count);
  void ReadBoundary();
  void ReadRootStates();
  void ReadSection(std::string_view section);
  void NumberVertices();
  void AddBoundary(std::size_t e, Geometry geometry, std::span<const int> corners);
  void CollectBoundary();
  void ReadPositions();

  TextScanner& Scanner;
  bool Scaled;
  int Rank = 0;
  std::vector<TreeElement> Elements;
  Leaves InOrder;
  std::vector<int> RootStates;
  VertexHierarchy Hierarchy;
  std::map<std::array<int, 4>, int> BoundaryAttribute; ///< by sorted nodes, -1 filling up
  std::unordered_map<int, int> VertexOf;               ///< by node
  std::vector<int> NodeOf;                             ///< by vertex
  MeshFile Mesh;
};

std::array<int, 4> Sorted(std::span<const int> nodes)
{
  std::array<int, 4> key{ -1, -1, -1, -1 };
  std::ranges::copy(nodes, key.begin());
  std::ranges::sort(key);
  return key;
}

void Forest::ReadHeader()
{
  Scanner.Expect("dimension");
  Mesh.dimension = ReadDimension(Scanner);
  if (Scanner.Peek() == "rank")
  {
    Scanner.Word("rank");
    Rank = Scanner.Integer("the rank");
  }
  if (Scanner.Peek() == "sfc_version")
  {
    Scanner.Word("sfc_version");
    Scanner.Integer("the version of the space-filling curve", 0, 0);
  }
}

void Forest::ReadElement(int index, int count)
{
  TreeElement& element = Elements[index];
  element.rank = Scanner.Integer("a rank");
  element.cell.attribute = Scanner.Integer("an attribute");
  const int geometry = Scanner.Integer("an element's geometry type", -1, 7);
  if (geometry < 0)
  {
    return; // a place that was left free
  }
  element.used = true;
  element.cell.geometry = static_cast<Geometry>(geometry);
  if (!IsOfDimension(element.cell.geometry, Mesh.dimension))
  {
    Scanner.Fail("geometry type " + std::to_string(geometry) + " is no element's of dimension " +
      std::to_string(Mesh.dimension) + ".");
  }
  element.refinement = Scanner.Integer(
    "a refinement type", 0, Mesh.dimension == 2 ? kPlaneDirections : kAllDirections);
  if (element.refinement != 0)
  {
    for (int& child : std::span(element.children).first(ChildrenOf(element.refinement)))
    {
      child = Scanner.Integer("a child", 0, count - 1);
    }
    return;
  }
  Mesh.ranks = std::max({ Mesh.ranks, Rank + 1, element.rank + 1 });
  for (int& node : std::span(element.cell.vertices).first(TableOf(element.cell.geometry).vertices))
  {
    node = Scanner.Integer("a vertex", 0, kMaxNodes);
  }
}

void Forest::ReadBoundary()
{
  const int count = Scanner.Count("the number of boundary elements", kShortestElement);
  for (int i = 0; i < count; ++i)
  {
    const Cell cell = ReadCell(Scanner, kMaxNodes, Mesh.dimension - 1);
    BoundaryAttribute[Sorted(std::span(cell.vertices).first(TableOf(cell.geometry).vertices))] =
      cell.attribute;
  }
}

void Forest::ReadRootStates()
{
  const int count = Scanner.Count("the number of root states", 2);
  for (int i = 0; i < count; ++i)
  {
    RootStates.push_back(
      Scanner.Integer("a root state", 0, (Mesh.dimension == 2 ? kPlaneStates : kStates) - 1));
  }
}

void Forest::NumberVertices()
{
  constexpr int kOpen = -2;
  constexpr int kListed = -1;
  const auto nodesOf = [this](int leaf)
  {
    const Cell& cell = Elements[leaf].cell;
    return std::span(cell.vertices).first(TableOf(cell.geometry).vertices);
  };
  for (const int leaf : InOrder.own)
  {
    for (const int node : nodesOf(leaf))
    {
      VertexOf[node] = kOpen;
    }
  }
  std::vector<int> coarse;
  std::vector<int> fine; // in the order of all leaves
  for (const int leaf : InOrder.all)
  {
    for (const int node : nodesOf(leaf))
    {
      const auto own = VertexOf.find(node);
      if (own != VertexOf.end() && own->second == kOpen)
      {
        own->second = kListed;
        (Hierarchy.HasParents(node) ? fine : coarse).push_back(node);
      }
    }
  }
  std::ranges::sort(coarse);
  NodeOf = coarse;
  NodeOf.insert(NodeOf.end(), fine.begin(), fine.end());
  for (std::size_t v = 0; v < NodeOf.size(); ++v)
  {
    VertexOf[NodeOf[v]] = static_cast<int>(v);
  }
  Mesh.vertices = static_cast<int>(NodeOf.size());
  for (const int leaf : InOrder.own)
  {
    Cell cell = Elements[leaf].cell;
    for (int& node : std::span(cell.vertices).first(TableOf(cell.geometry).vertices))
    {
      node = VertexOf.at(node);
    }
    Mesh.elements.push_back(cell);
  }
}

/// A face of a leaf, or an edge of a plane one, where the file has an attribute for it.
void Forest::AddBoundary(std::size_t e, Geometry geometry, std::span<const int> corners)
{
  const Cell& nodes = Elements[InOrder.own[e]].cell;
  Cell cell{ geometry, 0, {} };
  std::array<int, 4> key{};
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    key[k] = nodes.vertices[corners[k]];
    cell.vertices[k] = Mesh.elements[e].vertices[corners[k]];
  }
  const auto found = BoundaryAttribute.find(Sorted(std::span(key).first(corners.size())));
  if (found != BoundaryAttribute.end())
  {
    cell.attribute = found->second;
    Mesh.boundary.push_back(cell);
  }
}

void Forest::CollectBoundary()
{
  for (std::size_t e = 0; e < InOrder.own.size() && !BoundaryAttribute.empty(); ++e)
  {
    const GeometryTable& table = TableOf(Elements[InOrder.own[e]].cell.geometry);
    for (const LocalFace& face : table.faces)
    {
      AddBoundary(
        e, face.geometry, std::span(face.vertices).first(TableOf(face.geometry).vertices));
    }
    for (const auto& edge : table.sides.empty() ? table.edges.first(0) : table.edges)
    {
      AddBoundary(e, Geometry::Segment, edge);
    }
  }
}

void Forest::ReadPositions()
{
  Hierarchy.ReadCoordinates(Scanner, Mesh.dimension);
  for (const int node : NodeOf)
  {
    const auto x = Hierarchy.Position(Scanner, node);
    Mesh.coordinates.insert(Mesh.coordinates.end(), x.begin(), x.end());
  }
}

void Forest::ReadSection(std::string_view section)
{
  if (section == "boundary")
  {
    ReadBoundary();
  }
  else if (section == "vertex_parents")
  {
    Hierarchy.ReadParents(Scanner, Scaled);
  }
  else if (section == "root_state")
  {
    ReadRootStates();
  }
  else
  {
    Scanner.Fail("'" + std::string(section.substr(0, 40)) +
      "' is no section of a non-conforming mesh that is read here.");
  }
}

MeshFile Forest::Read()
{
  ReadHeader();
  Scanner.Expect("elements");
  const int count = Scanner.Count("the number of elements", kShortestElement);
  Elements.resize(count);
  for (int i = 0; i < count; ++i)
  {
    ReadElement(i, count);
  }
  LinkChildren(Scanner, Elements);
  std::string_view section;
  while ((section = Scanner.Word("a section of the mesh")) != "coordinates" && section != "nodes")
  {
    ReadSection(section);
  }
  InOrder = LeavesInOrder(Scanner, Elements, RootStates, Rank);
  NumberVertices();
  CollectBoundary();
  if (section == "nodes")
  {
    Mesh.nodes = ReadGridFunction(Scanner);
  }
  else
  {
    ReadPositions();
  }
  if (Scanner.Peek() == "mfem_mesh_end")
  {
    Scanner.Word("the end of the mesh");
  }
  return std::move(Mesh);
}
} // namespace

MeshFile ReadNonconforming(TextScanner& scanner, bool scaled)
{
  return Forest(scanner, scaled).Read();
}
} // namespace pixelexact::mfem
