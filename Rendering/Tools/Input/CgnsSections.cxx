// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CgnsSections.h"

#include <vtk_cgns.h>
#include VTK_CGNS(cgnslib.h)

#include <vector>

namespace pixelexact
{
namespace
{
using SectionName = std::array<char, 65>; // longer than the library's

/// Corners of elements that may be sides; 0: it is none. Of each kind they come first.
int CornersOf(CGNS_ENUMT(ElementType_t) type)
{
  switch (type)
  {
    case CGNS_ENUMV(BAR_2):
    case CGNS_ENUMV(BAR_3):
    case CGNS_ENUMV(BAR_4):
    case CGNS_ENUMV(BAR_5):
      return 2;
    case CGNS_ENUMV(TRI_3):
    case CGNS_ENUMV(TRI_6):
    case CGNS_ENUMV(TRI_9):
    case CGNS_ENUMV(TRI_10):
    case CGNS_ENUMV(TRI_12):
    case CGNS_ENUMV(TRI_15):
      return 3;
    case CGNS_ENUMV(QUAD_4):
    case CGNS_ENUMV(QUAD_8):
    case CGNS_ENUMV(QUAD_9):
    case CGNS_ENUMV(QUAD_12):
    case CGNS_ENUMV(QUAD_16):
    case CGNS_ENUMV(QUAD_25):
      return 4;
    default:
      return 0;
  }
}

/// A section's nodes, and each element's offset; in mixed sections the element's type is stored
/// there.
struct Section
{
  CGNS_ENUMT(ElementType_t) type{};
  std::int64_t first = 0;
  std::size_t elements = 0;
  int each = 0; ///< nodes of an element; 0: mixed
  std::vector<cgsize_t> nodes;
  std::vector<cgsize_t> offsets;
};

/// False where the nodes contradict the zone.
bool AddSides(const Section& section, std::int64_t points, CgnsSections& sections)
{
  for (std::size_t e = 0; e < section.elements; ++e)
  {
    std::size_t at = e * static_cast<std::size_t>(section.each);
    CGNS_ENUMT(ElementType_t) own = section.type;
    if (section.each == 0)
    {
      const cgsize_t offset = section.offsets[e];
      if (offset < 0 || static_cast<std::size_t>(offset) >= section.nodes.size())
      {
        return false;
      }
      at = static_cast<std::size_t>(offset);
      own = static_cast<CGNS_ENUMT(ElementType_t)>(section.nodes[at++]);
    }
    const auto corners = static_cast<std::size_t>(CornersOf(own));
    if (at + corners > section.nodes.size())
    {
      return false;
    }
    CgnsBoundary::Face face{ -1, -1, -1, -1 };
    for (std::size_t k = 0; k < corners; ++k)
    {
      face[k] = static_cast<std::int64_t>(section.nodes[at + k]) - 1;
      if (face[k] < 0 || face[k] >= points)
      {
        return false;
      }
    }
    if (corners > 0)
    {
      sections.sides[section.first + static_cast<std::int64_t>(e)] = face;
    }
  }
  return true;
}
} // namespace

CgnsAnswer ReadCgnsSections(
  int file, int base, int zone, std::int64_t points, bool wantSides, CgnsSections& sections)
{
  int count = 0;
  if (cg_nsections(file, base, zone, &count) != CG_OK)
  {
    return CgnsAnswer::Failed;
  }
  bool sound = true;
  for (int s = 1; s <= count; ++s)
  {
    Section section;
    SectionName name{};
    cgsize_t first = 0;
    cgsize_t last = 0;
    cgsize_t size = 0;
    int boundary = 0;
    int parents = 0;
    if (cg_section_read(file, base, zone, s, name.data(), &section.type, &first, &last, &boundary,
          &parents) != CG_OK)
    {
      return CgnsAnswer::Failed;
    }
    const bool mixed = section.type == CGNS_ENUMV(MIXED);
    sections.types.insert(cg_ElementTypeName(section.type));
    if (!wantSides || (!mixed && CornersOf(section.type) == 0))
    {
      continue;
    }
    if (cg_ElementDataSize(file, base, zone, s, &size) != CG_OK ||
      (!mixed && cg_npe(section.type, &section.each) != CG_OK))
    {
      return CgnsAnswer::Failed;
    }
    if (first < 1 || last < first || last > kMaxCgnsCount || size < 0 || size > 64 * kMaxCgnsCount)
    {
      sound = false;
      continue;
    }
    section.first = first;
    section.elements = static_cast<std::size_t>(last - first + 1);
    section.nodes.resize(static_cast<std::size_t>(size));
    section.offsets.resize(section.elements + 1);
    if ((mixed ? cg_poly_elements_read(
                   file, base, zone, s, section.nodes.data(), section.offsets.data(), nullptr)
               : cg_elements_read(file, base, zone, s, section.nodes.data(), nullptr)) != CG_OK)
    {
      return CgnsAnswer::Failed;
    }
    sound = AddSides(section, points, sections) && sound;
  }
  return sound ? CgnsAnswer::Sound : CgnsAnswer::Contradictory;
}
} // namespace pixelexact
