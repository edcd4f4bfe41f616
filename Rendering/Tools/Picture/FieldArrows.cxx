// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FieldArrows.h"

#include "Picture/Projection.h"
#include "Scene/Model.h"
#include "Scene/Shot.h"

#include "Core/Location/Sample.h"
#include "Views/VtkLook.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

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

/// The exact pixels nearest to a grid of a spacing.
std::vector<Place> PlacesOf(const SampleBuffers& samples, double spacing)
{
  std::vector<Place> places;
  for (double y = 0.5 * spacing; y < samples.height; y += spacing)
  {
    for (double x = 0.5 * spacing; x < samples.width; x += spacing)
    {
      const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.width) +
        static_cast<std::size_t>(x);
      if (samples.verdict[pixel] == static_cast<std::uint8_t>(PixelVerdict::Exact))
      {
        places.push_back({ samples.position[pixel], samples.normal[pixel], Vec3(0.0) });
      }
    }
  }
  return places;
}

/// Evaluates the field at the places, and removes those where it has no finite value.
void AddVectors(const Shot& shot, const Field& field, std::vector<Place>& places)
{
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  points.reserve(places.size());
  normals.reserve(places.size());
  for (const Place& place : places)
  {
    points.push_back(place.x);
    normals.push_back(place.normal);
  }
  const auto components = static_cast<std::size_t>(field.values.components);
  std::vector<double> values(components * places.size());
  std::vector<Verdict> verdicts(places.size());
  SampleTarget target;
  target.verdict = verdicts;
  target.value = values;
  target.normals = normals;
  Sample(*shot.scene.locator, &field, points, target);
  std::vector<Place> known;
  known.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    Place place = places[i];
    for (std::size_t c = 0; c < components; ++c)
    {
      place.vector[static_cast<int>(c)] = values[components * i + c];
    }
    if (verdicts[i] == Verdict::Inside && std::isfinite(glm::dot(place.vector, place.vector)))
    {
      known.push_back(place);
    }
  }
  places = std::move(known);
}

/// The part of a vector across the ray to its place, in pixels.
double PixelsAcross(const Projection& projection, const CameraView& view, const Place& place)
{
  const Vec3 forward = AxesOf(view).forward;
  const Vec3 way = place.x - view.position;
  const Vec3 ray = view.parallel ? forward : glm::normalize(way);
  const Vec3 across = place.vector - glm::dot(place.vector, ray) * ray;
  return glm::length(across) / projection.PixelAt(glm::dot(way, forward));
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
  return IsAsked() ? Buffer::Position | Buffer::Normal | Buffer::Verdict : Buffer::None;
}

double FieldArrows::SpacingFor(int width) const
{
  return Spacing ? Spacing->Pixels() : std::max(kMinSpacing, width / kAcross);
}

FoundArrows FieldArrows::Find(const Shot& shot, const Frame& frame) const
{
  const pixelexact::Field& field = VectorField(*shot.input.model, "--arrows", Name);
  const double spacing = SpacingFor(frame.width);
  std::vector<Place> places = PlacesOf(frame.centres, spacing);
  AddVectors(shot, field, places);
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
    found.longest = std::max(found.longest, glm::length(place.vector));
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
