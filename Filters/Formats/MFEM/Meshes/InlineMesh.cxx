// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/MeshFile.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>

namespace pixelexact::mfem
{
namespace
{
/// Limit of elements that a file of a few lines may request; MFEM's examples have thousands.
constexpr double kMaxElements = 1e6;
constexpr int kMaxAlongSide = 1 << 20;

/// How a cell of the box is divided into elements: by its corners, in MFEM's order, and its centre
/// (8).
struct Split
{
  const char* type;
  Geometry geometry;
  int dimension;
  std::vector<std::array<int, 8>> elements;
};

const std::vector<Split>& Splits()
{
  static const std::vector<Split> splits{
    { "quad", Geometry::Square, 2, { { 0, 1, 2, 3 } } },
    { "tri", Geometry::Triangle, 2, { { 0, 2, 3 }, { 0, 1, 2 } } },
    { "hex", Geometry::Cube, 3, { { 0, 1, 2, 3, 4, 5, 6, 7 } } },
    { "wedge", Geometry::Prism, 3, { { 0, 1, 2, 4, 5, 6 }, { 0, 2, 3, 4, 6, 7 } } },
    { "tet", Geometry::Tetrahedron, 3,
      { { 0, 1, 2, 6 }, { 0, 5, 1, 6 }, { 0, 4, 5, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 },
        { 0, 7, 4, 6 } } },
    { "pyramid", Geometry::Pyramid, 3,
      { { 0, 1, 2, 3, 8 }, { 0, 4, 5, 1, 8 }, { 1, 5, 6, 2, 8 }, { 2, 6, 7, 3, 8 },
        { 3, 7, 4, 0, 8 }, { 7, 6, 5, 4, 8 } } },
  };
  return splits;
}

constexpr std::array<std::array<int, 3>, 8> kCorners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
  { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };

/// MFEM's attributes of the sides: the lower and the upper one across x, y and z.
constexpr std::array<std::array<int, 2>, 3> kPlaneSides{ { { 4, 2 }, { 1, 3 }, { 0, 0 } } };
constexpr std::array<std::array<int, 2>, 3> kSides{ { { 5, 3 }, { 2, 4 }, { 1, 6 } } };

struct Box
{
  const Split* split = nullptr;
  std::array<int, 3> cells{ 0, 0, 0 };
  std::array<double, 3> sides{ 0.0, 0.0, 0.0 };
};

/// The text without blanks at its ends.
std::string Trimmed(std::string_view text)
{
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  while (!text.empty() && isBlank(text.front()))
  {
    text.remove_prefix(1);
  }
  return std::string(text);
}

/// Reads entries "name = word", one a line or separated by semicolons.
std::map<std::string, std::string> ReadEntries(TextScanner& scanner)
{
  std::map<std::string, std::string> entries;
  while (!scanner.Peek().empty())
  {
    std::string_view line = scanner.RestOfLine();
    while (!line.empty())
    {
      const std::string_view entry = line.substr(0, line.find(';'));
      line.remove_prefix(std::min(entry.size() + 1, line.size()));
      const auto at = entry.find('=');
      if (at == std::string_view::npos ||
        !entries.try_emplace(Trimmed(entry.substr(0, at)), Trimmed(entry.substr(at + 1))).second)
      {
        scanner.Fail("'" + std::string(entry.substr(0, 40)) +
          "' is no entry of an INLINE mesh, such as 'nx = 4', or is there twice.");
      }
    }
  }
  return entries;
}

/// Returns an entry that must be a positive number.
double Positive(TextScanner& scanner, std::map<std::string, std::string>& entries,
  const std::string& name, bool isWhole)
{
  const auto entry = entries.find(name);
  const std::string text = entry == entries.end() ? std::string() : entry->second;
  TextScanner one({ scanner.Name(), text });
  double number = 0.0;
  if (text.empty() || !one.TryNumber(number) || !one.Peek().empty() || !(number > 0.0) ||
    !(number < 1e300) ||
    (isWhole && (number > kMaxAlongSide || number != static_cast<int>(number))))
  {
    scanner.Fail("the entry '" + name + "' of the INLINE mesh is no positive " +
      (isWhole ? "whole number: '" : "number: '") + text.substr(0, 40) + "'.");
  }
  entries.erase(entry);
  return number;
}

Box ReadBox(TextScanner& scanner)
{
  auto entries = ReadEntries(scanner);
  const std::string type = entries["type"];
  entries.erase("type");
  if (type == "segment")
  {
    scanner.FailUnsupported(
      "the mesh is 1-dimensional; only two- and three-dimensional ones are read.");
  }
  Box box;
  const auto split = std::ranges::find_if(
    Splits(), [&type](const Split& candidate) { return type == candidate.type; });
  if (split == Splits().end())
  {
    scanner.Fail("the type '" + type.substr(0, 40) +
      "' of the INLINE mesh is none of tri, quad, tet, hex, wedge and pyramid.");
  }
  box.split = &*split;
  auto elements = static_cast<double>(box.split->elements.size());
  for (int d = 0; d < box.split->dimension; ++d)
  {
    const char axis = "xyz"[d];
    box.cells[d] = static_cast<int>(Positive(scanner, entries, std::string("n") + axis, true));
    box.sides[d] = Positive(scanner, entries, std::string("s") + axis, false);
    elements *= box.cells[d];
  }
  if (elements > kMaxElements)
  {
    scanner.FailUnsupported(
      "the INLINE mesh has more than a million elements; save it as a mesh (Mesh::Save).");
  }
  if (!entries.empty())
  {
    scanner.Fail(
      "'" + entries.begin()->first.substr(0, 40) + "' is no entry of a mesh of type " + type + ".");
  }
  return box;
}

class BoxMesh
{
public:
  explicit BoxMesh(const Box& box)
    : Source(box)
    , Points{ box.cells[0] + 1, box.cells[1] + 1, box.cells[2] + 1 }
  {
    Mesh.dimension = box.split->dimension;
    AddVertices();
    for (int k = 0; k < std::max(1, box.cells[2]); ++k)
    {
      for (int j = 0; j < box.cells[1]; ++j)
      {
        for (int i = 0; i < box.cells[0]; ++i)
        {
          AddCell({ i, j, k });
        }
      }
    }
  }

  MeshFile Mesh;

private:
  using Index = std::array<int, 3>;

  /// Coordinate d of a lattice point, with MFEM's rounding.
  [[nodiscard]] double At(int d, double index) const
  {
    return Source.cells[d] > 0 ? index / Source.cells[d] * Source.sides[d] : 0.0;
  }

  void AddVertex(double i, double j, double k)
  {
    Mesh.coordinates.insert(Mesh.coordinates.end(), { At(0, i), At(1, j), At(2, k) });
    ++Mesh.vertices;
  }

  void AddVertices()
  {
    ForIndices(Points, 0.0);
    if (Source.split->geometry == Geometry::Pyramid)
    {
      ForIndices(Source.cells, 0.5);
    }
  }

  void ForIndices(const Index& count, double offset)
  {
    for (int k = 0; k < count[2]; ++k)
    {
      for (int j = 0; j < count[1]; ++j)
      {
        for (int i = 0; i < count[0]; ++i)
        {
          AddVertex(i + offset, j + offset, k + offset);
        }
      }
    }
  }

  void AddCell(const Index& at)
  {
    std::array<int, 9> corners{};
    for (std::size_t c = 0; c < kCorners.size(); ++c)
    {
      const auto& [x, y, z] = kCorners[c];
      corners[c] = at[0] + x + Points[0] * (at[1] + y + Points[1] * (at[2] + z));
    }
    corners[8] = Points[0] * Points[1] * Points[2] + at[0] +
      Source.cells[0] * (at[1] + Source.cells[1] * at[2]);
    for (const auto& element : Source.split->elements)
    {
      Cell cell{ Source.split->geometry, 1, {} };
      const GeometryTable& table = TableOf(cell.geometry);
      for (int v = 0; v < table.vertices; ++v)
      {
        cell.vertices[v] = corners[element[v]];
      }
      Mesh.elements.push_back(cell);
      for (const LocalFace& face : table.faces)
      {
        AddSide(
          cell, face.geometry, std::span(face.vertices).first(TableOf(face.geometry).vertices));
      }
      for (const auto& edge : table.sides.empty() ? table.edges.first(0) : table.edges)
      {
        AddSide(cell, Geometry::Segment, edge);
      }
    }
  }

  /// Adds a boundary element for each side of the box that contains all these vertices.
  void AddSide(const Cell& element, Geometry geometry, std::span<const int> local)
  {
    for (int d = 0; d < Mesh.dimension; ++d)
    {
      for (std::size_t end = 0; end < 2; ++end)
      {
        const int wanted = end == 0 ? 0 : Source.cells[d];
        if (std::ranges::all_of(
              local, [&](int v) { return IndexOf(element.vertices[v], d) == wanted; }))
        {
          Cell side{ geometry, (Mesh.dimension == 2 ? kPlaneSides : kSides)[d][end], {} };
          std::ranges::transform(
            local, side.vertices.begin(), [&](int v) { return element.vertices[v]; });
          Mesh.boundary.push_back(side);
        }
      }
    }
  }

  /// The lattice index of a vertex along an axis; -1 for a cell's centre.
  [[nodiscard]] int IndexOf(int vertex, int d) const
  {
    if (vertex >= Points[0] * Points[1] * Points[2])
    {
      return -1;
    }
    const int below = d == 0 ? 1 : (d == 1 ? Points[0] : Points[0] * Points[1]);
    return vertex / below % Points[d];
  }

  const Box& Source;
  Index Points;
};
} // namespace

MeshFile ReadInline(TextScanner& scanner)
{
  const Box box = ReadBox(scanner);
  MeshFile mesh = std::move(BoxMesh(box).Mesh);
  mesh.isNumbered = false;
  return mesh;
}
} // namespace pixelexact::mfem
