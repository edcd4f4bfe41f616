// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/Geometry.h"

#include "Core/Base/ParseWhole.h"
#include "Formats/Nektar/Geometry/CurvePoints.h"

#include <algorithm>
#include <optional>

namespace pixelexact::nektar
{
namespace
{
constexpr int kHighestCurveOrder = kMaxOrder;

struct PointType
{
  const char* name;
  int number; ///< in compressed files: Nektar++'s enumeration of point types
  Distribution distribution;
};
constexpr PointType kPointTypes[] = {
  { "PolyEvenlySpaced", 17, Distribution::Equispaced },
  { "GaussLobattoLegendre", 4, Distribution::GaussLobatto },
  { "GaussLobattoChebyshev", 8, Distribution::LobattoChebyshev },
  { "NodalTriEvenlySpaced", 24, Distribution::TriangleEquispaced },
  { "NodalTriElec", 22, Distribution::TriangleElectrostatic },
  { "NodalTriFekete", 23, Distribution::TriangleFekete },
};

/// A curve's record in a compressed file.
struct CurveRecord
{
  std::int64_t id;
  std::int64_t entity;
  std::int64_t points;
  std::int64_t set;
  std::int64_t offset;
  std::int64_t type;
};

struct PointRecord
{
  std::int64_t id;
  Point x;
};

/// The order of a curve with this number of points; none where no order has it.
std::optional<int> OrderOf(std::size_t points, bool face, bool triangular)
{
  for (int order = 1; order <= kHighestCurveOrder; ++order)
  {
    const auto n = static_cast<std::size_t>(order) + 1;
    if (points == (!face ? n : triangular ? n * (n + 1) / 2 : n * n))
    {
      return order;
    }
  }
  return std::nullopt;
}

class CurveReader
{
public:
  CurveReader(const Document& document, const Transform& transform, Geometry& geometry)
    : File(document)
    , Place(transform)
    , Target(geometry)
  {
  }

  void ReadPlain(const pugi::xml_node& curved)
  {
    for (const auto& node : curved.children())
    {
      const bool face = std::string_view(node.name()) == "F";
      if (node.type() != pugi::node_element)
      {
        continue;
      }
      if (!face && std::string_view(node.name()) != "E")
      {
        File.FailUnsupported(node, "curves are those of edges (E) and faces (F); this is neither.");
      }
      const auto numbers = File.Numbers(node);
      const std::int64_t expected = File.Id(node, "NUMPOINTS");
      if (numbers.size() % 3 != 0 || static_cast<std::size_t>(expected) != numbers.size() / 3)
      {
        File.Fail(node,
          "there are " + std::to_string(numbers.size()) + " coordinates for " +
            std::to_string(expected) + " points.");
      }
      std::vector<Point> points(numbers.size() / 3);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        std::copy_n(&numbers[3 * i], 3, points[i].begin());
      }
      const std::string_view type = WithoutBlanks(node.attribute("TYPE").value());
      const auto* known = std::ranges::find(kPointTypes, type, &PointType::name);
      Add(node, face, File.Id(node, face ? "FACEID" : "EDGEID"),
        known == std::end(kPointTypes) ? nullptr : known, std::string(type), std::move(points));
    }
    if (Place != Transform{} && curved.child("F"))
    {
      Target.notes.push_back(File.Name() +
        ": the points of its curved faces are scaled and moved as its vertices are; Nektar++ "
        "itself leaves those of an uncompressed file where they are.");
    }
  }

  void ReadCompressed(const pugi::xml_node& curved)
  {
    const pugi::xml_node data = File.Only(curved, "DATAPOINTS");
    const auto index =
      File.Records<std::int64_t>(File.Only(data, "INDEX"), File.MostBytes() / sizeof(std::int64_t));
    const auto points =
      File.Records<PointRecord>(File.Only(data, "POINTS"), File.MostBytes() / sizeof(PointRecord));
    for (const char* tag : { "E", "F" })
    {
      if (const pugi::xml_node node = File.Only(curved, tag))
      {
        for (const auto& record :
          File.Records<CurveRecord>(node, File.MostBytes() / sizeof(CurveRecord)))
        {
          AddRecord(node, *tag == 'F', record, index, points);
        }
      }
    }
  }

private:
  void AddRecord(const pugi::xml_node& node, bool face, const CurveRecord& record,
    const std::vector<std::int64_t>& index, const std::vector<PointRecord>& points)
  {
    const auto size = static_cast<std::int64_t>(index.size());
    if (record.points < 2 || record.offset < 0 || record.points > size ||
      record.offset > size - record.points)
    {
      File.Fail(node,
        "the curve of " + std::to_string(record.entity) +
          " lies outside of the list of points; the file is damaged.");
    }
    std::vector<Point> own;
    for (std::int64_t k = record.offset; k < record.offset + record.points; ++k)
    {
      if (index[k] < 0 || index[k] >= static_cast<std::int64_t>(points.size()))
      {
        File.Fail(node,
          "the curve of " + std::to_string(record.entity) +
            " has a point that is not there; the file is damaged.");
      }
      own.push_back(points[index[k]].x);
    }
    const auto* known = std::ranges::find(kPointTypes, record.type, &PointType::number);
    Add(node, face, record.entity, known == std::end(kPointTypes) ? nullptr : known,
      "number " + std::to_string(record.type), std::move(own));
  }

  void Add(const pugi::xml_node& node, bool face, std::int64_t entity, const PointType* type,
    const std::string& typeName, std::vector<Point> points)
  {
    const std::string name = std::string(face ? "face " : "edge ") + std::to_string(entity);
    if (!type)
    {
      File.FailUnsupported(node,
        "the points of " + name + " are of type '" + typeName.substr(0, 40) +
          "', which is not read; PolyEvenlySpaced, GaussLobattoLegendre, GaussLobattoChebyshev, "
          "NodalTriEvenlySpaced, NodalTriElec and NodalTriFekete are.");
    }
    const bool triangular = IsTriangular(type->distribution);
    const auto order = OrderOf(points.size(), face, triangular);
    if (!order || (triangular && !face))
    {
      File.Fail(node,
        name + " has " + std::to_string(points.size()) + " points, which makes no curve of type " +
          type->name + ".");
    }
    if (*order > HighestOrder(type->distribution))
    {
      File.FailUnsupported(node,
        "the points of " + name + " are of type " + type->name + " and order " +
          std::to_string(*order) + "; up to order " +
          std::to_string(HighestOrder(type->distribution)) + " they are read.");
    }
    int* slot = nullptr;
    if (face)
    {
      const auto found = Target.faces.find(entity);
      slot = found == Target.faces.end() ? nullptr : &found->second.curve;
      if (slot && (found->second.corners == 3) != triangular)
      {
        File.Fail(node, name + " and its points differ in shape.");
      }
    }
    else
    {
      const auto found = Target.edges.find(entity);
      slot = found == Target.edges.end() ? nullptr : &found->second.curve;
    }
    // A piece of a larger mesh may keep curves of what is elsewhere.
    if (slot)
    {
      std::ranges::transform(points, points.begin(), Place);
      Insert(node, name, { type->distribution, *order, std::move(points) }, *slot);
    }
  }

  void Insert(const pugi::xml_node& node, const std::string& name, Curve&& curve, int& slot)
  {
    if (slot < 0)
    {
      slot = static_cast<int>(Target.curves.size());
      Target.curves.push_back(std::move(curve));
    }
    else if (!(Target.curves[slot] == curve))
    {
      File.Fail(node,
        "the points of " + name +
          " are there twice, and not the same; files that are read together must be the parts of "
          "one mesh.");
    }
  }

  const Document& File;
  const Transform& Place;
  Geometry& Target;
};
} // namespace

void ReadCurves(const Document& document, const pugi::xml_node& curved, const Transform& transform,
  Geometry& geometry)
{
  CurveReader reader(document, transform, geometry);
  if (document.IsCompressed(curved))
  {
    reader.ReadCompressed(curved);
  }
  else
  {
    reader.ReadPlain(curved);
  }
}
} // namespace pixelexact::nektar
