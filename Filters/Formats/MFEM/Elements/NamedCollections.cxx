// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/NamedCollections.h"

#include "Core/Base/Error.h"
#include "Core/Base/Quote.h"

#include <array>
#include <string_view>

namespace pixelexact::mfem
{
namespace
{
/// Longer names are shown shortened in messages.
constexpr std::size_t kLongestShown = 60;
constexpr const char* kOnFaces = "trace spaces live on faces; save the field itself";
constexpr const char* kProject =
  "project the field to H1 or L2 (ProjectGridFunction) and save that";
} // namespace

std::string QuoteName(const std::string& text)
{
  return Quote(text, kLongestShown);
}

void RefuseCollection(const std::string& text, const std::string& reason)
{
  throw Unsupported(
    "the finite element collection " + QuoteName(text) + " is not supported: " + reason + ".");
}

void RefuseDimension(const std::string& text, int dimension, int wanted)
{
  RefuseCollection(text,
    "it is one of " + std::to_string(dimension) + "-D elements, but those of the mesh are " +
      std::to_string(wanted) + "-D; the grid function belongs to another mesh");
}

std::optional<CollectionName> FixedCollection(const std::string& text, int dimension)
{
  struct Entry
  {
    std::string_view name;
    Continuity continuity;
    int order;
    bool shared;
    int dimension; ///< 0: of any
  };
  static constexpr std::array kEntries{
    Entry{ "Linear", Continuity::H1, 1, true, 0 },
    Entry{ "Quadratic", Continuity::H1, 2, true, 0 },
    Entry{ "Cubic", Continuity::H1, 3, true, 0 },
    Entry{ "Const2D", Continuity::L2, 0, false, 2 },
    Entry{ "LinearDiscont2D", Continuity::L2, 1, false, 2 },
    Entry{ "QuadraticDiscont2D", Continuity::L2, 2, false, 2 },
    Entry{ "CubicDiscont2D", Continuity::L2, 3, false, 2 },
    Entry{ "RT0_2D", Continuity::HDiv, 0, true, 2 },
    Entry{ "Const3D", Continuity::L2, 0, false, 3 },
    Entry{ "LinearDiscont3D", Continuity::L2, 1, false, 3 },
    Entry{ "QuadraticDiscont3D", Continuity::L2, 2, false, 3 },
    Entry{ "ND1_3D", Continuity::HCurl, 1, true, 3 },
    Entry{ "RT0_3D", Continuity::HDiv, 0, true, 3 },
    Entry{ "RT1_3D", Continuity::HDiv, 1, true, 3 },
  };
  for (const Entry& entry : kEntries)
  {
    if (text == entry.name)
    {
      if (entry.dimension != 0 && entry.dimension != dimension)
      {
        RefuseDimension(text, entry.dimension, dimension);
      }
      CollectionName name;
      name.text = text;
      name.continuity = entry.continuity;
      name.order = entry.order;
      name.dimension = dimension;
      name.closed = LineBasis::ClosedUniform;
      name.open = LineBasis::OpenUniform;
      name.shared = entry.shared;
      name.legacy = true;
      return name;
    }
  }
  return std::nullopt;
}

void RefuseOtherCollections(const std::string& text)
{
  struct Entry
  {
    std::string_view begin;
    const char* reason;
  };
  static constexpr std::array kEntries{
    Entry{ "NURBS",
      "it is a NURBS space; project the field to an H1 or L2 space in MFEM "
      "(ProjectGridFunction) and save that" },
    Entry{ "H1_Trace", kOnFaces },
    Entry{ "H1Pos_Trace", kOnFaces },
    Entry{ "RT_Trace", kOnFaces },
    Entry{ "RT_ValTrace", kOnFaces },
    Entry{ "ND_Trace", kOnFaces },
    Entry{ "DG_I", "interface spaces live on faces; save the field itself" },
    Entry{ "H1Ser_", "serendipity spaces are not read; project the field to H1 and save that" },
    Entry{ "RT_R", kProject },
    Entry{ "ND_R", kProject },
    Entry{ "Local_", "local spaces are not read; project the field to H1 or L2 and save that" },
    Entry{ "LinearNonConf3D", "project the field to L2 and save that" },
    Entry{ "CrouzeixRaviart", kProject },
    Entry{ "QuadraticPos", kProject },
    Entry{ "P1OnQuad", kProject },
    Entry{ "GaussLinearDiscont2D", kProject },
    Entry{ "GaussQuadraticDiscont2D", kProject },
    Entry{ "RT1_2D", kProject },
    Entry{ "RT2_2D", kProject },
  };
  for (const Entry& entry : kEntries)
  {
    if (text.starts_with(entry.begin))
    {
      RefuseCollection(text, entry.reason);
    }
  }
}
} // namespace pixelexact::mfem
