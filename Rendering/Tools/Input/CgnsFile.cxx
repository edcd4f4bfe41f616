// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CgnsFile.h"

#include "Input/CgnsSections.h"
#include "Input/CgnsStructured.h"
#include "Input/Input.h"

#include <vtk_cgns.h>
#include VTK_CGNS(cgnslib.h)

#include <algorithm>
#include <limits>
#include <map>

namespace pixelexact
{
namespace
{
using Name = std::array<char, 65>; // of the library's, with all that families may have

class CgnsReader
{
public:
  explicit CgnsReader(const std::string& path)
    : Path(path)
  {
    if (cg_open(path.c_str(), CG_MODE_READ, &Id) != CG_OK)
    {
      Id = -1;
      Fail();
    }
  }
  ~CgnsReader()
  {
    if (Id >= 0)
    {
      cg_close(Id);
    }
  }
  CgnsReader(const CgnsReader&) = delete;
  CgnsReader& operator=(const CgnsReader&) = delete;

  std::vector<CgnsZone> Read()
  {
    std::vector<CgnsZone> zones;
    int bases = 0;
    Require(cg_nbases(Id, &bases));
    for (Base = 1; Base <= bases; ++Base)
    {
      int count = 0;
      int space = 0;
      Name name{};
      Require(cg_base_read(Id, Base, name.data(), &CellDimension, &space));
      Require(cg_nzones(Id, Base, &count));
      for (Zone = 1; Zone <= count; ++Zone)
      {
        ReadZone(zones.emplace_back());
      }
    }
    return zones;
  }

private:
  [[noreturn]] void Fail() const
  {
    CannotRead(Path,
      std::string("the CGNS library says: ") + cg_get_error() +
        "; it is damaged or of another version: copy it again, or write it with the library's own "
        "tools (cgnsconvert)");
  }

  void Require(int status) const
  {
    if (status != CG_OK)
    {
      Fail();
    }
  }

  /// Thrown for numbers that the zone does not have. They are noted, but the mesh is still read.
  struct Contradiction
  {
  };
  static void RequireSound(bool sound)
  {
    if (!sound)
    {
      throw Contradiction();
    }
  }

  void ReadZone(CgnsZone& zone)
  {
    CGNS_ENUMT(ZoneType_t) type{};
    Require(cg_zone_type(Id, Base, Zone, &type));
    Name name{};
    std::array<cgsize_t, 9> size{};
    Require(cg_zone_read(Id, Base, Zone, name.data(), size.data()));
    const bool structured = type == CGNS_ENUMV(Structured);
    Grid.directions = structured ? CellDimension : 1;
    zone.points = Grid.directions >= 1 && Grid.directions <= 3 ? 1 : -1;
    Grid.extent = { 1, 1, 1 };
    for (int d = 0; d < Grid.directions && zone.points >= 0; ++d)
    {
      const auto own = static_cast<std::int64_t>(size[static_cast<std::size_t>(d)]);
      Grid.extent[static_cast<std::size_t>(d)] = own;
      zone.points = own >= 0 && own <= kMaxCgnsCount ? zone.points * own : -1;
      zone.points = zone.points > kMaxCgnsCount ? -1 : zone.points;
    }
    if (zone.points < 0)
    {
      return; // VTK's reader says what it makes of it
    }
    zone.isSingle = HasSingleCoordinates();
    int count = 0;
    Require(cg_nbocos(Id, Base, Zone, &count));
    CgnsSections sections;
    if (!structured)
    {
      const CgnsAnswer answer = ReadCgnsSections(Id, Base, Zone, zone.points, count > 0, sections);
      Require(answer == CgnsAnswer::Failed ? CG_ERROR : CG_OK);
      if (answer == CgnsAnswer::Contradictory)
      {
        sections.sides.clear(); // notes name the conditions that need them
      }
    }
    zone.elements = std::move(sections.types);
    Sides = std::move(sections.sides);
    for (Condition = 1; Condition <= count; ++Condition)
    {
      ReadCondition(structured, zone);
    }
  }

  [[nodiscard]] bool HasSingleCoordinates() const
  {
    int coordinates = 0;
    Require(cg_ncoords(Id, Base, Zone, &coordinates));
    bool isSingle = coordinates > 0;
    for (int c = 1; c <= coordinates; ++c)
    {
      CGNS_ENUMT(DataType_t) type{};
      Name name{};
      Require(cg_coord_info(Id, Base, Zone, c, &type, name.data()));
      isSingle = isSingle && type == CGNS_ENUMV(RealSingle);
    }
    return isSingle;
  }

  void ReadCondition(bool structured, CgnsZone& zone)
  {
    Name own{};
    CGNS_ENUMT(BCType_t) kind{};
    CGNS_ENUMT(PointSetType_t) set{};
    CGNS_ENUMT(DataType_t) normalType{};
    CGNS_ENUMT(GridLocation_t) location{};
    std::array<int, 3> normalIndex{};
    cgsize_t count = 0;
    cgsize_t normals = 0;
    int dataSets = 0;
    const bool known = cg_boco_info(Id, Base, Zone, Condition, own.data(), &kind, &set, &count,
                         normalIndex.data(), &normals, &normalType, &dataSets) == CG_OK &&
      cg_boco_gridlocation_read(Id, Base, Zone, Condition, &location) == CG_OK;
    CgnsBoundary boundary;
    boundary.name = NameOf(own.data(), kind);
    const bool possible =
      known && count >= 0 && count <= kMaxCgnsCount && normals >= 0 && normals <= 3 * kMaxCgnsCount;
    std::vector<cgsize_t> numbers(possible ? static_cast<std::size_t>(count * Grid.directions) : 0);
    std::vector<double> ignored(possible ? static_cast<std::size_t>(normals) : 0);
    if (!possible ||
      cg_boco_read(Id, Base, Zone, Condition, numbers.data(), ignored.data()) != CG_OK)
    {
      zone.left.push_back(boundary.name);
      return;
    }
    const bool isElements = set == CGNS_ENUMV(ElementRange) || set == CGNS_ENUMV(ElementList);
    const bool isRange = set == CGNS_ENUMV(PointRange) || set == CGNS_ENUMV(ElementRange);
    bool read = false;
    try
    {
      RequireSound(!isRange || count == 2);
      if (structured)
      {
        read = AddStructured(numbers, isRange, location, boundary);
      }
      else
      {
        read = location == CGNS_ENUMV(Vertex) && !isElements
          ? AddPoints(numbers, isRange, zone.points, boundary)
          : AddElements(numbers, isRange, boundary);
      }
    }
    catch (const Contradiction&)
    {
      read = false;
    }
    if (read)
    {
      zone.boundaries.push_back(std::move(boundary));
    }
    else
    {
      zone.left.push_back(boundary.name);
    }
  }

  std::string NameOf(const char* own, CGNS_ENUMT(BCType_t) kind) const
  {
    std::array<char, 33 * 21> family{}; // paths of families, in the library's newer versions
    if (kind == CGNS_ENUMV(FamilySpecified) &&
      cg_goto(Id, Base, "Zone_t", Zone, "ZoneBC_t", 1, "BC_t", Condition, "end") == CG_OK &&
      cg_famname_read(family.data()) == CG_OK && family[0] != '\0')
    {
      return family.data();
    }
    return own;
  }

  static bool AddPoints(
    const std::vector<cgsize_t>& numbers, bool isRange, std::int64_t points, CgnsBoundary& boundary)
  {
    const auto all = isRange ? Range(numbers[0], numbers[1], points) : numbers;
    for (const cgsize_t number : all)
    {
      RequireSound(number >= 1 && number <= points);
      boundary.points.push_back(static_cast<std::int64_t>(number) - 1);
    }
    return true;
  }

  bool AddElements(const std::vector<cgsize_t>& numbers, bool isRange, CgnsBoundary& boundary) const
  {
    const auto add = [&](const auto& side) { boundary.faces.push_back(side.second); };
    if (isRange)
    {
      // Visits the sides that exist in the range, without going through all of its numbers.
      std::for_each(Sides.lower_bound(std::min(numbers[0], numbers[1])),
        Sides.upper_bound(std::max(numbers[0], numbers[1])), add);
    }
    for (std::size_t i = 0; i < numbers.size() && !isRange; ++i)
    {
      if (const auto side = Sides.find(numbers[i]); side != Sides.end())
      {
        add(*side);
      }
    }
    return !boundary.faces.empty() || numbers.empty();
  }

  static std::vector<cgsize_t> Range(cgsize_t first, cgsize_t last, std::int64_t most)
  {
    RequireSound(first >= 1 && last >= first && last <= most);
    std::vector<cgsize_t> all;
    for (cgsize_t number = first; number <= last; ++number)
    {
      all.push_back(number);
    }
    return all;
  }

  bool AddStructured(const std::vector<cgsize_t>& numbers, bool isRange,
    CGNS_ENUMT(GridLocation_t) location, CgnsBoundary& boundary) const
  {
    const std::vector<std::int64_t> places(numbers.begin(), numbers.end());
    const bool isVertex = location == CGNS_ENUMV(Vertex);
    if (!isRange)
    {
      return isVertex && Grid.AddPoints(places, boundary);
    }
    const int across = location == CGNS_ENUMV(IFaceCenter) ? 0
      : location == CGNS_ENUMV(JFaceCenter)                ? 1
      : location == CGNS_ENUMV(KFaceCenter)                ? 2
                                                           : -1;
    return (isVertex || across >= 0) && Grid.AddFaces(places, across, boundary);
  }

  const std::string& Path;
  int Id = -1;
  int Base = 1;
  int Zone = 1;
  int Condition = 1;
  int CellDimension = 3;
  CgnsStructured Grid; ///< one direction: an unstructured zone
  std::map<std::int64_t, CgnsBoundary::Face> Sides;
};
} // namespace

std::vector<CgnsZone> ReadCgnsZones(const std::string& file)
{
  return CgnsReader(file).Read();
}
} // namespace pixelexact
