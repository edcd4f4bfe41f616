// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/NamedCollections.h"

#include "Core/Base/Error.h"

#include <array>
#include <string_view>

namespace pixelexact::mfem
{
namespace
{
/// Longer names are shown shortened in messages.
constexpr std::size_t kLongestShown = 60;
constexpr const char* kOnFaces = "trace spaces live on faces; save the field itself";
constexpr const char* kPlane = "it is one of 1-D or 2-D elements; PixelExact shows solid elements";
} // namespace

std::string Quoted(const std::string& text)
{
  std::string shown = "'";
  for (const char c : text.substr(0, kLongestShown))
  {
    shown += c >= ' ' && c <= '~' ? c : '?';
  }
  return shown + (text.size() > kLongestShown ? "...'" : "'");
}

void RefuseCollection(const std::string& text, const std::string& reason)
{
  throw Unsupported(
    "the finite element collection " + Quoted(text) + " is not supported: " + reason + ".");
}

std::optional<CollectionName> FixedCollection(const std::string& text)
{
  struct Entry
  {
    std::string_view name;
    Continuity continuity;
    int order;
    bool shared;
  };
  static constexpr std::array kEntries{
    Entry{ "Linear", Continuity::H1, 1, true },
    Entry{ "Quadratic", Continuity::H1, 2, true },
    Entry{ "Cubic", Continuity::H1, 3, true },
    Entry{ "Const3D", Continuity::L2, 0, false },
    Entry{ "LinearDiscont3D", Continuity::L2, 1, false },
    Entry{ "QuadraticDiscont3D", Continuity::L2, 2, false },
    Entry{ "ND1_3D", Continuity::HCurl, 1, true },
    Entry{ "RT0_3D", Continuity::HDiv, 0, true },
    Entry{ "RT1_3D", Continuity::HDiv, 1, true },
  };
  for (const Entry& entry : kEntries)
  {
    if (text == entry.name)
    {
      CollectionName name;
      name.text = text;
      name.continuity = entry.continuity;
      name.order = entry.order;
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
    Entry{ "RT_R", kPlane },
    Entry{ "ND_R", kPlane },
    Entry{ "Local_", "local spaces are not read; project the field to H1 or L2 and save that" },
    Entry{ "LinearNonConf3D", "project the field to L2 and save that" },
    Entry{ "CrouzeixRaviart", kPlane },
    Entry{ "QuadraticPos", kPlane },
    Entry{ "P1OnQuad", kPlane },
  };
  for (const Entry& entry : kEntries)
  {
    if (text.starts_with(entry.begin))
    {
      RefuseCollection(text, entry.reason);
    }
  }
  static constexpr std::array kPlaneNames{ "Const2D", "LinearDiscont2D", "GaussLinearDiscont2D",
    "QuadraticDiscont2D", "GaussQuadraticDiscont2D", "CubicDiscont2D", "RT0_2D", "RT1_2D",
    "RT2_2D" };
  for (const char* name : kPlaneNames)
  {
    if (text == name)
    {
      RefuseCollection(text, kPlane);
    }
  }
}
} // namespace pixelexact::mfem
