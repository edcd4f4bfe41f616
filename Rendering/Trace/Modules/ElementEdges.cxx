// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ElementEdges.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/Error.h"
#include "Trace/Modules/FaceLines.h"
#include "Trace/Modules/LineShare.h"
#include "Trace/Scene.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace pixelexact
{
namespace
{
/// Distance from a pixel's centre to its corners, in pixels.
constexpr double kCentreToCorner = 0.71;

/// Kinds in the order of drawing; later ones are on top.
constexpr std::array kOrder{ FaceKind::Interior, FaceKind::Partly, FaceKind::Hanging,
  FaceKind::Boundary };

using Shares = std::array<double, kOrder.size()>; ///< of a pixel, by FaceKind

/// The part of a pixel that a line covers: on the inner side of the face, or on both sides.
double ShareOf(const FaceLine& line, double width, bool inside)
{
  const auto behind = [&line](double to) { return ShareBehind(line.towards, to); };
  // A pixel outside the boundary is drawn if its centre shows the surface.
  return inside ? 1.0 - behind(line.distance - width)
                : behind(line.distance + 0.5 * width) - behind(line.distance - 0.5 * width);
}

double Fade(const FaceLine& line, double width)
{
  return std::clamp((line.elementSize / width - 1.0) / (ElementEdges::kFullSize - 1.0), 0.0, 1.0);
}

void Draw(const Rgba& color, double share, std::uint8_t* to)
{
  const double part = share * color[3] / 255.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    to[c] = static_cast<std::uint8_t>(std::lround(to[c] + part * (color[c] - to[c])));
  }
}
} // namespace

EdgeStyle EdgeStyle::ByKind(double width)
{
  EdgeStyle style;
  style.width = width;
  const auto set = [&style](FaceKind kind, const Rgba& color)
  { style.colors[static_cast<std::size_t>(kind)] = color; };
  set(FaceKind::Interior, { 0, 0, 0, 255 });
  set(FaceKind::Boundary, { 0, 114, 178, 255 });
  set(FaceKind::Hanging, { 230, 159, 0, 255 });
  set(FaceKind::Partly, { 204, 121, 167, 255 });
  return style;
}

EdgeStyle EdgeStyle::Plain(double width, const Rgba& color)
{
  return { width, { color, color, color, color } };
}

ElementEdges::ElementEdges(const EdgeStyle& style, KindOfFace kinds)
  : Style(style)
  , Kinds(std::move(kinds))
{
  if (!(style.width >= EdgeStyle::kNarrowest && style.width <= EdgeStyle::kWidest))
  {
    std::ostringstream text;
    text << "a line width of " << style.width << " pixels: elements' edges may be "
         << EdgeStyle::kNarrowest << " to " << EdgeStyle::kWidest << " pixels wide";
    throw Error(text.str());
  }
}

SampleNeeds ElementEdges::Needs() const
{
  return { .centres = Buffer::Verdict | Buffer::Element | Buffer::Xi | Buffer::Position |
      Buffer::Normal | Buffer::Layer };
}

void ElementEdges::Begin(int /*width*/, int /*height*/) {}

void ElementEdges::Process(TileVisit& tile)
{
  Frame& frame = tile.GetFrame();
  if (frame.color.empty())
  {
    return;
  }
  // Windows draw the sheets of translucent layers one by one; lines are on the nearest sheet.
  const bool onSheet = HasTranslucent(tile.GetScene());
  const CheckedOut<FaceLines> search;
  // At the boundary all of the width is on one side.
  const double reach = (Kinds ? Style.width : 0.5 * Style.width) + kCentreToCorner;
  const auto lines = (*search).Find(tile, reach);
  const auto kindOf = [this](int element, int face)
  { return Kinds ? Kinds(element, face) : FaceKind::Interior; };
  for (std::size_t begin = 0, end = 0; begin < lines.size(); begin = end)
  {
    Shares shares{};
    for (; end < lines.size() && lines[end].pixel == lines[begin].pixel; ++end)
    {
      const FaceLine& line = lines[end];
      const FaceKind kind = kindOf(line.element, line.face);
      // The surface does not leave the mesh where it lies on another boundary face.
      const bool leaves = kind == FaceKind::Boundary &&
        (line.lyingOn < 0 || kindOf(line.element, line.lyingOn) != FaceKind::Boundary);
      double& share = shares[static_cast<std::size_t>(kind)];
      share = std::max(share, ShareOf(line, Style.width, leaves) * Fade(line, Style.width));
    }
    for (const FaceKind kind : kOrder)
    {
      const auto at = static_cast<std::size_t>(kind);
      Draw(Style.colors[at], shares[at], &frame.color[4 * lines[begin].pixel]);
      if (onSheet)
      {
        Draw(Style.colors[at], shares[at], &frame.centres.color[4 * lines[begin].pixel]);
      }
    }
  }
}
} // namespace pixelexact
