// SPDX-License-Identifier: BSD-3-Clause
// Names and meanings are those of the chapter "HOPR HDF5 Curved Mesh Format" of HOPR's user guide
// (hopr.readthedocs.io, November 2023).
#include "Formats/Flexi/MeshFile.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Element/ElementUnits.h"
#include "Formats/Assembly.h"
#include "Formats/Flexi/StateFile.h"
#include "Formats/Hdf5/Hdf5File.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace pixelexact::flexi
{
namespace
{
constexpr std::int64_t kMaxGeometryOrder = 32;
constexpr std::int64_t kMaxElements = std::int64_t{ 1 } << 31;

/// The columns of ElemInfo and SideInfo.
enum ElementColumn : std::uint8_t
{
  kType,
  kZone,
  kFirstSide,
  kLastSide,
  kFirstNode,
  kLastNode
};
enum SideColumn : std::uint8_t
{
  kNeighbour = 2,
  kCondition = 4
};

[[noreturn]] void RefuseMesh(const std::string& name, const std::string& why)
{
  throw InvalidData(name + ": " + why + "; the mesh is damaged: write or copy it again.");
}

/// A table of integers.
struct Table
{
  std::vector<std::int64_t> values;
  std::size_t columns = 0;

  [[nodiscard]] std::size_t Rows() const { return columns == 0 ? 0 : values.size() / columns; }
  [[nodiscard]] std::int64_t At(std::size_t row, std::size_t column) const
  {
    return values[row * columns + column];
  }
};

Table ReadTable(const Hdf5File& mesh, const std::string& name, const char* set, std::size_t columns)
{
  const std::string path = std::string("/") + set;
  const std::vector<std::size_t> shape = mesh.Shape(path);
  if (shape.size() != 2 || shape[1] < columns)
  {
    RefuseMesh(name, std::string(set) + " has not " + std::to_string(columns) + " columns");
  }
  return { mesh.Integers(path), shape[1] };
}

std::int64_t Attribute(const Hdf5File& mesh, const char* attribute)
{
  const auto values = mesh.IntegerAttributes("/", attribute);
  return values.empty() ? -1 : values[0];
}

/// The kinds of elements, by the number of their corners, which is the last digit of their type.
const char* KindOf(std::int64_t type)
{
  if (type < 100)
  {
    return "plane element";
  }
  switch (type % 10)
  {
    case 4:
      return "tetrahedron";
    case 5:
      return "pyramid";
    case 6:
      return "prism";
    case 8:
      return "hexahedron";
    default:
      return "element of unknown type";
  }
}

void RequireHexahedra(const std::string& name, const Table& elements)
{
  std::map<std::string, std::int64_t> others;
  for (std::size_t e = 0; e < elements.Rows(); ++e)
  {
    if (const std::string kind = KindOf(elements.At(e, kType)); kind != "hexahedron")
    {
      ++others[kind];
    }
  }
  std::string text;
  for (const auto& [kind, count] : others)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " of kind '" + kind + "'";
  }
  if (!text.empty())
  {
    throw Unsupported(name + ": not all elements are hexahedra: " + text +
      "; let HOPR split them: splitToHex = T.");
  }
}

/// Lagrange's polynomials of equispaced nodes, of which xi1 is the fastest.
ElementBasis MapBasis(int order)
{
  const Space space = UniformSpace(Shape::Hexahedron, order);
  const int n = order + 1;
  std::vector<int> source;
  source.reserve(static_cast<std::size_t>(n) * n * n);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int k = 0; k < n; ++k)
      {
        source.push_back(i + n * (j + n * k));
      }
    }
  }
  ElementBasis basis;
  basis.parts.push_back(ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, source));
  basis.sources = n * n * n;
  return basis;
}

/// The first node of each element.
std::vector<std::size_t> FirstNodes(
  const std::string& name, const Table& elements, std::size_t nodes, std::size_t ofElement)
{
  std::vector<std::size_t> first;
  first.reserve(elements.Rows());
  for (std::size_t e = 0; e < elements.Rows(); ++e)
  {
    const std::int64_t begin = elements.At(e, kFirstNode);
    const std::int64_t end = elements.At(e, kLastNode);
    if (begin < 0 || end < begin || static_cast<std::size_t>(end) > nodes ||
      static_cast<std::size_t>(end - begin) != ofElement)
    {
      RefuseMesh(name,
        "element " + std::to_string(e + 1) + " has the nodes " + std::to_string(begin) + " to " +
          std::to_string(end) + " of " + std::to_string(nodes) + ", but a hexahedron has " +
          std::to_string(ofElement));
    }
    first.push_back(static_cast<std::size_t>(begin));
  }
  return first;
}

/// Adds corners by the nodes' global numbers; elements have corners of their own where the file has
/// no sound numbers.
void AddCorners(const Hdf5File& mesh, int order, const std::vector<std::size_t>& first,
  std::size_t nodes, SolverMesh& result)
{
  constexpr std::array<std::array<int, 3>, 8> kCorners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };
  const int n = order + 1;
  std::vector<std::int64_t> numbers;
  if (mesh.Has("/GlobalNodeIDs"))
  {
    numbers = mesh.Integers("/GlobalNodeIDs");
  }
  const bool isSound = numbers.size() == nodes &&
    std::ranges::all_of(numbers,
      [nodes](std::int64_t number)
      { return number > 0 && static_cast<std::size_t>(number) <= nodes; });
  for (std::size_t e = 0; e < first.size(); ++e)
  {
    Corners corners{};
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      const auto [i, j, k] = kCorners[c];
      const int node = order * (i + n * (j + n * k));
      corners[c] = isSound ? numbers[first[e] + static_cast<std::size_t>(node)]
                           : static_cast<std::int64_t>(corners.size() * e + c);
    }
    result.corners.push_back(corners);
  }
}

/// The small sides that follow a side which is divided.
std::int64_t SmallSides(std::int64_t neighbour)
{
  constexpr std::int64_t kBoth = -1; ///< divided in both directions
  return neighbour >= 0 ? 0 : neighbour == kBoth ? 4 : 2;
}

void AddBoundary(
  const Hdf5File& mesh, const std::string& name, const Table& elements, SolverMesh& result)
{
  if (!mesh.Has("/SideInfo"))
  {
    return;
  }
  // The file numbers sides as CGNS: across -z, -y, x, y, -x, z.
  constexpr std::array<std::int8_t, 6> kVtkFace{ 4, 2, 1, 3, 0, 5 };
  const Table sides = ReadTable(mesh, name, "SideInfo", kCondition + 1);
  std::set<std::int64_t> used;
  for (std::size_t e = 0; e < elements.Rows(); ++e)
  {
    const std::int64_t last = elements.At(e, kLastSide);
    std::size_t face = 0;
    for (std::int64_t side = elements.At(e, kFirstSide); side < last; ++side)
    {
      if (side < 0 || static_cast<std::size_t>(side) >= sides.Rows() || face == kVtkFace.size())
      {
        RefuseMesh(name, "element " + std::to_string(e + 1) + " has sides that do not exist");
      }
      const auto row = static_cast<std::size_t>(side);
      const std::int64_t condition = sides.At(row, kCondition);
      if (condition > 0 && condition <= kMaxElements - 1)
      {
        result.boundary.push_back(
          { static_cast<std::int32_t>(e), kVtkFace[face], static_cast<std::int32_t>(condition) });
        used.insert(condition);
      }
      side += SmallSides(sides.At(row, kNeighbour));
      ++face;
    }
  }
  const auto names = mesh.Has("/BCNames") ? mesh.Texts("/BCNames") : std::vector<std::string>();
  for (const std::int64_t condition : used)
  {
    const std::string text = condition <= std::ssize(names)
      ? PlainText(names[static_cast<std::size_t>(condition - 1)])
      : "";
    result.groups.push_back({ static_cast<std::int32_t>(condition), text, true });
  }
}
} // namespace

bool IsMesh(const Hdf5File& file)
{
  return file.Has("/ElemInfo") && file.Has("/NodeCoords");
}

std::int64_t CountElements(const Hdf5File& mesh)
{
  const std::vector<std::size_t> shape = mesh.Shape("/ElemInfo");
  return shape.empty() ? 0 : static_cast<std::int64_t>(shape[0]);
}

SolverMesh ReadMesh(const Hdf5File& mesh, const std::string& name)
{
  const Table elements = ReadTable(mesh, name, "ElemInfo", kLastNode + 1);
  const std::int64_t order = Attribute(mesh, "Ngeo");
  if (order < 1 || order > kMaxGeometryOrder)
  {
    throw Unsupported(name + ": the order of its elements (Ngeo) is " + std::to_string(order) +
      "; orders from 1 to " + std::to_string(kMaxGeometryOrder) + " are read.");
  }
  if (elements.Rows() == 0 ||
    Attribute(mesh, "nElems") !=
      std::ssize(elements.values) / static_cast<std::int64_t>(elements.columns) ||
    std::ssize(elements.values) > kMaxElements)
  {
    RefuseMesh(name, "its number of elements (nElems) is not that of ElemInfo");
  }
  RequireHexahedra(name, elements);
  const std::vector<std::size_t> shape = mesh.Shape("/NodeCoords");
  if (shape.size() != 2 || shape[1] != 3)
  {
    RefuseMesh(name, "the rows of NodeCoords are not x, y and z");
  }
  const ElementBasis basis = MapBasis(static_cast<int>(order));
  const auto ofElement = static_cast<std::size_t>(basis.sources);
  const std::vector<std::size_t> first = FirstNodes(name, elements, shape[0], ofElement);
  const std::vector<double> places = mesh.Reals("/NodeCoords");
  const bool isSingle = mesh.BytesOfValue("/NodeCoords") <= sizeof(float);
  const double roundoff = isSingle ? kFloatRoundoff : kUnitRoundoff;

  SolverMesh result;
  const std::vector<const ElementBasis*> bases(elements.Rows(), &basis);
  AssembleMap(
    bases,
    [&](std::size_t e, std::span<double> source)
    {
      for (std::size_t node = 0; node < ofElement; ++node)
      {
        for (std::size_t d = 0; d < 3; ++d)
        {
          source[d * ofElement + node] = places[3 * (first[e] + node) + d];
        }
      }
    },
    [&](std::size_t e) { return name + ": element " + std::to_string(e + 1); }, result, roundoff);
  DropRoundedOrders(bases, roundoff, result);
  for (std::size_t e = 0; e < elements.Rows(); ++e)
  {
    result.number.push_back(static_cast<std::int64_t>(e) + 1);
    result.attribute.push_back(static_cast<std::int32_t>(elements.At(e, kZone)));
  }
  AddCorners(mesh, static_cast<int>(order), first, shape[0], result);
  AddBoundary(mesh, name, elements, result);
  return result;
}
} // namespace pixelexact::flexi
