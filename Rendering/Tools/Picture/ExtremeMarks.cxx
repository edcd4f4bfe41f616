// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ExtremeMarks.h"

#include "Base/Report.h"
#include "Cuts/IntegralPieces.h"
#include "Cuts/SurfaceStatistics.h"
#include "Drawing/Canvas.h"
#include "Drawing/Ticks.h"
#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "Core/Contour/SurfaceAbilities.h"
#include "Trace/Projection.h"
#include "Trace/Surfaces/ElementFaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

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

/// A rectangle of a picture.
struct MarkBox
{
  double left;
  double bottom;
  double right;
  double top;

  [[nodiscard]] bool Meets(const MarkBox& other) const
  {
    return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
  }
};

/// The place of a label beside a mark, within the picture and off the boxes where possible.
MarkBox PlaceOf(const CanvasPoint& at, double length, int font, const Frame& frame,
  const std::vector<MarkBox>& taken)
{
  const double half = 0.7 * font;
  const auto box = [&](double left, double middle) {
    return MarkBox{ left - 2.0, middle - half, left + length + 3.0, middle + half };
  };
  const double right = at[0] + font;
  const double left = at[0] - font - length;
  const double above = at[1] + 1.5 * font;
  const double below = at[1] - 1.5 * font;
  const std::array places{ box(right, at[1]), box(left, at[1]), box(right, above),
    box(right, below), box(left, above), box(left, below) };
  const auto isFree = [&](const MarkBox& place)
  {
    return place.left >= 0.0 && place.right <= frame.width && place.bottom >= 0.0 &&
      place.top <= frame.height &&
      std::ranges::none_of(taken, [&](const MarkBox& other) { return other.Meets(place); });
  };
  const auto* const found = std::ranges::find_if(places, isFree);
  return found != places.end() ? *found : right + length > frame.width ? places[1] : places[0];
}

void DrawRing(Canvas& canvas, const CanvasPoint& at, int font)
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
}

void DrawLabel(Canvas& canvas, const MarkBox& box, const std::string& text)
{
  canvas.Fill(static_cast<int>(box.left), static_cast<int>(box.bottom),
    static_cast<int>(box.right - box.left), static_cast<int>(box.top - box.bottom), kHalo);
  canvas.Write(text, box.left + 2.0, 0.5 * (box.bottom + box.top), TextAnchor::Left, kRing);
}
} // namespace

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
  std::vector<std::pair<CanvasPoint, std::string>> marks;
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
      marks.emplace_back(at->at, fmt::format("{} {}", name, WithMinus(Short(extreme.value, 4))));
    }
  }
  std::vector<MarkBox> taken;
  taken.reserve(2 * marks.size());
  for (const auto& [at, text] : marks)
  {
    DrawRing(canvas, at, font);
    taken.push_back(
      { at[0] - 0.7 * font, at[1] - 0.7 * font, at[0] + 0.7 * font, at[1] + 0.7 * font });
  }
  for (const auto& [at, text] : marks)
  {
    taken.push_back(PlaceOf(at, canvas.WidthOf(text), font, frame, taken));
    DrawLabel(canvas, taken.back(), text);
  }
}
} // namespace pixelexact
