// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/Hdf5Xml.h"

#include "Core/Base/Error.h"
#include "Formats/Hdf5/Hdf5File.h"
#include "Formats/Nektar/Files/XmlBlocks.h"

#include <algorithm>
#include <array>

namespace pixelexact::nektar
{
namespace
{
const std::string kGeometry = "/NEKTAR/GEOMETRY";
constexpr std::int64_t kNewestVersion = 2;

struct Entity
{
  const char* set;
  const char* tag;
  std::size_t parts;
};
constexpr std::array kFaces{ Entity{ "TRI", "T", 3 }, Entity{ "QUAD", "Q", 4 } };
constexpr std::array kSolids{ Entity{ "TET", "A", 4 }, Entity{ "PYR", "P", 5 },
  Entity{ "PRISM", "R", 5 }, Entity{ "HEX", "H", 6 } };

std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return escaped;
}

class MeshWriter
{
public:
  MeshWriter(const Hdf5File& file, const std::string& name)
    : File(file)
    , Name(name)
  {
  }

  std::string Write()
  {
    const auto version = File.IntegerAttributes(kGeometry, "FORMAT_VERSION");
    if (version.size() != 1 || version[0] < 1 || version[0] > kNewestVersion)
    {
      throw Unsupported(Name + ": the version of its geometry is not 1 or " +
        std::to_string(kNewestVersion) + ", which are read.");
    }
    const bool solid = std::ranges::any_of(
      kSolids, [this](const Entity& e) { return File.Has(kGeometry + "/MESH/" + e.set); });
    const std::string dimension = solid ? "3" : "2";
    std::string xml = "<NEKTAR><GEOMETRY DIM=\"" + dimension + "\" SPACE=\"3\">";
    xml += Vertices() + Edges();
    if (solid)
    {
      xml += "<FACE>" + Block("T", Records(kFaces[0])) + Block("Q", Records(kFaces[1])) + "</FACE>";
    }
    xml += "<ELEMENT>";
    for (const Entity& element : solid ? std::span<const Entity>(kSolids) : std::span(kFaces))
    {
      xml += Block(element.tag, Records(element));
    }
    xml += "</ELEMENT>" + Curves() + Composites();
    return xml + "</GEOMETRY></NEKTAR>";
  }

private:
  /// The numbers of what a data set holds, one for each row.
  std::vector<std::int64_t> Ids(const std::string& set, std::size_t rows) const
  {
    auto ids = File.Integers(kGeometry + "/MAPS/" + set);
    if (ids.size() != rows)
    {
      throw InvalidData(Name + ": MESH/" + set + " has " + std::to_string(rows) +
        " rows, but MAPS/" + set + " " + std::to_string(ids.size()) +
        "; the file contradicts itself.");
    }
    return ids;
  }

  void RequireColumns(const std::string& set, std::size_t columns) const
  {
    const auto shape = File.Shape(kGeometry + "/MESH/" + set);
    if (shape.size() != 2 || shape[1] != columns)
    {
      throw InvalidData(Name + ": MESH/" + set + " should have " + std::to_string(columns) +
        " columns; the file contradicts itself.");
    }
  }

  /// Number and parts of each entity, one after the other; none where there is no such data set.
  std::vector<std::int64_t> Records(const Entity& entity) const
  {
    std::vector<std::int64_t> records;
    if (!File.Has(kGeometry + "/MESH/" + entity.set))
    {
      return records;
    }
    RequireColumns(entity.set, entity.parts);
    const auto parts = File.Integers(kGeometry + "/MESH/" + entity.set);
    const auto ids = Ids(entity.set, parts.size() / entity.parts);
    records.reserve(parts.size() + ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      records.push_back(ids[i]);
      records.insert(
        records.end(), &parts[i * entity.parts], &parts[i * entity.parts] + entity.parts);
    }
    return records;
  }

  std::string Vertices() const
  {
    RequireColumns("VERT", 3);
    const auto places = File.Reals(kGeometry + "/MESH/VERT");
    return Block("VERTEX", PointRecords(Ids("VERT", places.size() / 3), places));
  }

  std::string Edges() const { return Block("EDGE", Records({ "SEG", "E", 2 })); }

  std::string Curves() const
  {
    if (!File.Has(kGeometry + "/MESH/CURVE_NODES"))
    {
      return "<CURVED/>";
    }
    RequireColumns("CURVE_NODES", 3);
    const auto places = File.Reals(kGeometry + "/MESH/CURVE_NODES");
    if (places.empty())
    {
      return "<CURVED/>";
    }
    std::vector<std::int64_t> index(places.size() / 3);
    for (std::size_t i = 0; i < index.size(); ++i)
    {
      index[i] = static_cast<std::int64_t>(i);
    }
    return "<CURVED " + std::string(kBlockAttributes) + ">" +
      Block("E", CurveRecords("CURVE_EDGE")) + Block("F", CurveRecords("CURVE_FACE")) +
      "<DATAPOINTS ID=\"0\">" + Block("INDEX", index) +
      Block("POINTS", PointRecords(index, places)) + "</DATAPOINTS></CURVED>";
  }

  /// The order is that of compressed XML: number, entity, points, set of points, the first point,
  /// type.
  std::vector<std::int64_t> CurveRecords(const std::string& set) const
  {
    std::vector<std::int64_t> records;
    if (!File.Has(kGeometry + "/MESH/" + set))
    {
      return records;
    }
    RequireColumns(set, 3);
    const auto curves = File.Integers(kGeometry + "/MESH/" + set); // points, type, first point
    const auto ids = Ids(set, curves.size() / 3);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      records.insert(records.end(),
        { static_cast<std::int64_t>(i), ids[i], curves[3 * i], 0, curves[3 * i + 2],
          curves[3 * i + 1] });
    }
    return records;
  }

  std::string Composites() const
  {
    const auto texts = File.Texts(kGeometry + "/MESH/COMPOSITE");
    const auto ids = Ids("COMPOSITE", texts.size());
    std::string xml = "<COMPOSITE>";
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      xml += "<C ID=\"" + std::to_string(ids[i]) + "\">" + Escaped(texts[i]) + "</C>";
    }
    return xml + "</COMPOSITE>";
  }

  const Hdf5File& File;
  const std::string& Name;
};
} // namespace

std::string Hdf5AsXml(const NamedText& file)
{
  const auto hdf5 = OpenHdf5(file.name, file.text);
  if (hdf5->Has(kGeometry))
  {
    return MeshWriter(*hdf5, file.name).Write();
  }
  if (hdf5->Has("/NEKTAR/DECOMPOSITION"))
  {
    return Hdf5Fields(*hdf5, file.name);
  }
  throw InvalidData(file.name +
    ": this HDF5 file has neither NEKTAR/GEOMETRY nor NEKTAR/DECOMPOSITION; it is no mesh and no "
    "field of Nektar++.");
}

std::string Hdf5Metadata(const std::string& path)
{
  const auto hdf5 = OpenHdf5(path);
  return hdf5->Has("/NEKTAR/DECOMPOSITION") ? Hdf5FieldsHead(*hdf5, path) : std::string();
}
} // namespace pixelexact::nektar
