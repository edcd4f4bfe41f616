// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ExtremeMarks.h"

#include "Base/Report.h"
#include "Cuts/IntegralPieces.h"
#include "Cuts/SurfaceStatistics.h"
#include "Drawing/Canvas.h"
#include "Picture/Projection.h"
#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "Core/Contour/SurfaceAbilities.h"
#include "Trace/Surfaces/ElementFaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact
{
namespace
{
constexpr Rgba kRing{ 0, 0, 0, 255 };
constexpr Rgba kHalo{ 255, 255, 255, 255 };
/// A surface less than this far in front of a point, in pixels, is the point's own.
constexpr double kOwnDepth = 3.0;

/// Polynomials that are positive where the scene removes surfaces.
std::vector<ImplicitPolynomial> ClipsOf(const Scene& scene)
{
  std::vector<ImplicitPolynomial> clips;
  for (const KeptHalfSpace& kept : scene.kept)
  {
    ImplicitPolynomial clip;
    clip.a.g = { -kept[0], -kept[1], -kept[2] };
    clip.a.c = -kept[3];
    clips.push_back(clip);
  }
  return clips;
}

std::optional<SurfaceExtremes> ExtremesOf(
  const Shot& shot, const Layer& layer, const std::vector<ImplicitPolynomial>& clips)
{
  const HighOrderModel& model = *shot.input.model;
  const int component = layer.field->values.components == 1 ? 0 : layer.component;
  if (const auto* const faces = dynamic_cast<const ElementFaces*>(layer.surface.get()))
  {
    return FindExtremesOnFaces(
      { model.GetMesh(), layer.field, nullptr, clips }, component, faces->Faces());
  }
  const std::vector<SurfacePatch> patches = IntegralPatchesOf(layer.surface->Implicit());
  if (patches.empty())
  {
    return std::nullopt;
  }
  return DomainOfPatches(patches, clips, model).extremes(*layer.field, component);
}

/// Whether the picture shows another surface in front of a point.
bool IsHidden(const Frame& frame, const ProjectedPoint& at, const Projection& projection)
{
  const auto x = static_cast<int>(std::floor(at.at[0]));
  const auto y = static_cast<int>(std::floor(at.at[1]));
  if (x < 0 || y < 0 || x >= frame.width || y >= frame.height)
  {
    return true;
  }
  // The surface may end or turn within the pixel: a neighbour may show it.
  double farthest = -1.0;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, frame.height - 1); ++j)
  {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, frame.width - 1); ++i)
    {
      const double depth =
        frame.centres.depth[static_cast<std::size_t>(j) * static_cast<std::size_t>(frame.width) +
          static_cast<std::size_t>(i)];
      farthest = std::isnan(depth) ? kInfinity : std::max(farthest, depth);
    }
  }
  return farthest < at.depth - kOwnDepth * projection.PixelAt(at.depth);
}

void DrawMark(Canvas& canvas, const CanvasPoint& at, const std::string& text, int font, int width)
{
  constexpr int kSides = 32;
  const double radius = 0.5 * font;
  std::vector<CanvasPoint> ring;
  ring.reserve(kSides + 1);
  for (int k = 0; k <= kSides; ++k)
  {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    ring.push_back({ at[0] + radius * std::cos(angle), at[1] + radius * std::sin(angle) });
  }
  canvas.Line(ring, 0.35 * font, kHalo);
  canvas.Line(ring, 0.15 * font, kRing);
  const double length = canvas.WidthOf(text);
  const bool isLeft = at[0] + font + length > width;
  const double from = isLeft ? at[0] - font - length : at[0] + font;
  canvas.Fill(static_cast<int>(from) - 2, static_cast<int>(at[1] - 0.7 * font),
    static_cast<int>(length) + 5, static_cast<int>(1.4 * font), kHalo);
  canvas.Write(text, from, at[1], TextAnchor::Left, kRing);
}
} // namespace

std::vector<SurfaceExtremes> ExtremeMarks::Find(const Shot& shot)
{
  const std::vector<ImplicitPolynomial> clips = ClipsOf(shot.scene);
  std::vector<SurfaceExtremes> all;
  for (const Layer& layer : shot.scene.layers)
  {
    if (layer.field != nullptr)
    {
      if (auto found = ExtremesOf(shot, layer, clips))
      {
        all.push_back(*found);
      }
    }
  }
  if (all.empty())
  {
    throw Error("--mark-extremes: no surface with a field has proven extremes: " +
      DescribeSurfacesWith(SurfaceUse::Integrals) + ", or --boundary");
  }
  return all;
}

void ExtremeMarks::Draw(Canvas& canvas, const Shot& shot, const Frame& frame,
  const std::vector<SurfaceExtremes>& all, int font)
{
  const Projection projection(shot.view, frame.width, frame.height);
  for (const SurfaceExtremes& surface : all)
  {
    for (const bool isMaximum : { false, true })
    {
      const Extreme& extreme = isMaximum ? surface.extremes.maximum : surface.extremes.minimum;
      const auto at =
        extreme.element >= 0 ? projection.Of(extreme.x) : std::optional<ProjectedPoint>();
      const char* const name = isMaximum ? "max" : "min";
      if (!at)
      {
        continue;
      }
      if (IsHidden(frame, *at, projection))
      {
        Note(
          fmt::format("--mark-extremes: the {} {} at ({}, {}, {}) is not visible: it has no mark",
            isMaximum ? "maximum" : "minimum", Short(extreme.value), Short(extreme.x.x),
            Short(extreme.x.y), Short(extreme.x.z)));
        continue;
      }
      DrawMark(
        canvas, at->at, fmt::format("{} {}", name, Short(extreme.value, 4)), font, frame.width);
    }
  }
}
} // namespace pixelexact
