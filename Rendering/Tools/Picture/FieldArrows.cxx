// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FieldArrows.h"

#include "Base/Report.h"
#include "Scene/Model.h"
#include "Scene/Shot.h"

#include "Core/Location/Locator.h"
#include "Core/Location/Sample.h"
#include "Trace/Projection.h"
#include "Views/VtkLook.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace pixelexact
{
namespace
{
/// Number of arrows across a picture, and the least distance between them in pixels.
constexpr double kAcross = 30.0;
constexpr double kMinSpacing = 8.0;
/// Length of the longest arrow, in units of the spacing.
constexpr double kLongest = 1.4;
// The shape of an arrow, in units of the shaft's width.
constexpr double kHeadLength = 6.0;
constexpr double kHeadWidth = 4.5;

/// A point of a surface, with its normal and the vector there.
struct Place
{
  Vec3 x;
  Vec3 normal;
  Vec3 vector;
};

double LengthOf(const Vec3& v)
{
  return std::hypot(v.x, v.y, v.z); // without overflow of squares
}

/// The vector at a pixel, in its element.
Vec3 VectorAt(const Shot& shot, const Field& field, const SampleBuffers& samples, std::size_t pixel)
{
  const auto components = static_cast<std::size_t>(field.values.components);
  std::array<double, 3> values{};
  EvaluateAt(shot.scene.locator->GetMesh(), field, static_cast<int>(samples.element[pixel]),
    std::span(&samples.xi[pixel], 1), std::span(values).first(components), {},
    { std::span(&samples.position[pixel], 1), std::span(&samples.normal[pixel], 1) });
  return { values[0], values[1], values[2] };
}

/// The exact pixels nearest to a grid of a spacing, on layers that are visible, where the field has
/// a finite vector.
std::vector<Place> PlacesOf(
  const Shot& shot, const Field& field, const SampleBuffers& samples, double spacing)
{
  std::vector<Place> places;
  for (double y = 0.5 * spacing; y < samples.height; y += spacing)
  {
    for (double x = 0.5 * spacing; x < samples.width; x += spacing)
    {
      const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.width) +
        static_cast<std::size_t>(x);
      if (samples.verdict[pixel] != static_cast<std::uint8_t>(PixelVerdict::Exact) ||
        shot.settings[samples.layer[pixel]].opacity <= 0.0)
      {
        continue;
      }
      const Place place{ samples.position[pixel], samples.normal[pixel],
        VectorAt(shot, field, samples, pixel) };
      if (std::isfinite(LengthOf(place.vector)))
      {
        places.push_back(place);
      }
    }
  }
  return places;
}

/// The part of a vector across the ray to its place, in pixels.
double PixelsAcross(const Projection& projection, const CameraView& view, const Place& place)
{
  const Vec3 forward = AxesOf(view).forward;
  const Vec3 way = place.x - view.position;
  const Vec3 ray = view.parallel ? forward : glm::normalize(way);
  const Vec3 across = place.vector - glm::dot(place.vector, ray) * ray;
  return LengthOf(across) / projection.PixelAt(glm::dot(way, forward));
}
} // namespace

void FieldArrows::AddTo(CLI::App& command)
{
  Bind(command, "--arrows", Name);
  Bind(command, "--arrow-spacing", Spacing);
  Bind(command, "--arrow-scale", Scale);
  Bind(command, "--arrow-width", Width);
  Bind(command, "--arrow-color", Color);
  Bind(command, "--arrows-tangential", Tangential);
}

void FieldArrows::ResolveLengths(const std::optional<double>& dpi)
{
  Width.Resolve(dpi);
  if (Spacing)
  {
    Spacing->Resolve(dpi);
  }
}

Buffer FieldArrows::Needs() const
{
  return IsAsked() ? Buffer::Position | Buffer::Normal | Buffer::Verdict | Buffer::Element |
      Buffer::Xi | Buffer::Layer
                   : Buffer::None;
}

double FieldArrows::SpacingFor(int width) const
{
  return Spacing ? Spacing->Pixels() : std::max(kMinSpacing, width / kAcross);
}

FoundArrows FieldArrows::Find(const Shot& shot, const Frame& frame) const
{
  const pixelexact::Field& field = VectorField(*shot.input.model, "--arrows", Name);
  const double spacing = SpacingFor(frame.width);
  std::vector<Place> places = PlacesOf(shot, field, frame.centres, spacing);
  FoundArrows found;
  found.field = field.name;
  const Projection projection(shot.view, frame.width, frame.height);
  double pixels = 0.0;
  for (Place& place : places)
  {
    if (Tangential)
    {
      place.vector -= glm::dot(place.vector, place.normal) * place.normal;
    }
    found.longest = std::max(found.longest, LengthOf(place.vector));
    pixels = std::max(pixels, PixelsAcross(projection, shot.view, place));
  }
  found.scale = Scale.value_or(pixels > 0.0 ? kLongest * spacing / pixels : 1.0);
  found.pixelsPerValue =
    found.scale / projection.PixelAt(glm::distance(shot.view.position, shot.view.focalPoint));
  for (const Place& place : places)
  {
    const auto from = projection.Of(place.x);
    const auto to = projection.Of(place.x + found.scale * place.vector);
    if (from && to)
    {
      found.arrows.push_back({ from->at, to->at });
    }
  }
  if (const std::size_t lost = places.size() - found.arrows.size(); lost > 0)
  {
    Note(fmt::format(
      "--arrows: {} of {} arrows are not drawn: they end behind the viewer", lost, places.size()));
  }
  return found;
}

void FieldArrows::Draw(Canvas& canvas, const FoundArrows& found) const
{
  for (const auto& [from, to] : found.arrows)
  {
    DrawOne(canvas, from, to);
  }
}

void FieldArrows::DrawOne(Canvas& canvas, const CanvasPoint& from, const CanvasPoint& to) const
{
  const Rgba color = ToRgba(Color.data());
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  const double width = Width.Pixels();
  const double rim = std::max(1.0, 0.6 * width);
  if (!(length > 0.5 * width))
  {
    canvas.Line(from, from, width + rim, InkOn(color));
    canvas.Line(from, from, width, color);
    return;
  }
  // Short arrows are thinner, so that all have one shape.
  const double unit = std::min(width, length / (1.3 * kHeadLength));
  const double head = kHeadLength * unit;
  const std::array along{ (to[0] - from[0]) / length, (to[1] - from[1]) / length };
  const auto at = [&](double forward, double left)
  {
    return CanvasPoint{ from[0] + forward * along[0] - left * along[1],
      from[1] + forward * along[1] + left * along[0] };
  };
  const std::array outline{ at(0.0, 0.5 * unit), at(length - head, 0.5 * unit),
    at(length - head, 0.5 * kHeadWidth * unit), at(length, 0.0),
    at(length - head, -0.5 * kHeadWidth * unit), at(length - head, -0.5 * unit),
    at(0.0, -0.5 * unit), at(0.0, 0.5 * unit) };
  canvas.Line(outline, rim, InkOn(color));
  canvas.FillPolygon(outline, color);
}
} // namespace pixelexact
