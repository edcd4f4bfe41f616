// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ContourCells.h"

#include "Trace/Camera.h"
#include "Trace/TileVisit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr std::array kNoRange{ std::numeric_limits<double>::infinity(),
  -std::numeric_limits<double>::infinity() };

/// A step shorter than this, in pixels, is the last.
constexpr double kSettled = 1e-4;
/// Steps beyond those that lead `far` pixels away. Convergence is quadratic, as Newton's.
constexpr int kMoreSteps = 8;

void Widen(std::array<double, 2>& range, const std::array<double, 2>& by)
{
  range = { std::min(range[0], by[0]), std::max(range[1], by[1]) };
}

/// 0 if there is one layer and no buffer of layers.
std::uint8_t LayerOfSample(const SampleBuffers& samples, std::size_t i)
{
  return samples.layer.empty() ? std::uint8_t{ 0 } : samples.layer[i];
}

bool IsWhole(const SampleBuffers& samples, const std::array<std::size_t, 4>& at)
{
  return std::ranges::all_of(at,
    [&](std::size_t i)
    {
      return samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
        std::isfinite(samples.value[i]) &&
        LayerOfSample(samples, i) == LayerOfSample(samples, at[0]);
    });
}

/// Two neighbouring corners lie on one sheet. `along`: the ray's direction. False if a number is
/// not finite.
bool AreOnOneSheet(const SampleBuffers& samples, std::size_t a, std::size_t b, const Vec3& along)
{
  const Vec3 chord = samples.position[b] - samples.position[a];
  const double length = glm::length(chord);
  const double across = glm::length(chord - glm::dot(chord, along) * along);
  const double facing = std::max(
    std::fabs(glm::dot(samples.normal[a], along)), std::fabs(glm::dot(samples.normal[b], along)));
  const double most = ContourCells::kOffTangent * length;
  return std::fabs(glm::dot(chord, samples.normal[a])) <= most &&
    std::fabs(glm::dot(chord, samples.normal[b])) <= most &&
    length * facing <= ContourCells::kTooLong * across;
}

/// The same for all four sides of a pixel.
bool AreOnOneSheet(
  const SampleBuffers& samples, const std::array<std::size_t, 4>& at, const Vec3& along)
{
  return AreOnOneSheet(samples, at[0], at[1], along) &&
    AreOnOneSheet(samples, at[2], at[3], along) && AreOnOneSheet(samples, at[0], at[2], along) &&
    AreOnOneSheet(samples, at[1], at[3], along);
}
} // namespace

void ContourCells::Begin(const LatticePart& corners, const TileArea& pixels, const Camera* camera)
{
  Pixels = pixels;
  const auto count =
    static_cast<std::size_t>(pixels.Width()) * static_cast<std::size_t>(pixels.Height());
  Layers.assign(count, kNoLayer);
  Values.resize(count);
  const SampleBuffers& samples = corners.samples;
  for (int y = pixels.y0; y < pixels.y1; ++y)
  {
    for (int x = pixels.x0; x < pixels.x1; ++x)
    {
      const std::array at{ corners.At(x, y), corners.At(x + 1, y), corners.At(x, y + 1),
        corners.At(x + 1, y + 1) };
      if (IsWhole(samples, at) &&
        (camera == nullptr || AreOnOneSheet(samples, at, camera->At(x + 0.5, y + 0.5).direction)))
      {
        const std::size_t cell = At(x, y);
        Layers[cell] = LayerOfSample(samples, at[0]);
        std::ranges::transform(
          at, Values[cell].begin(), [&samples](std::size_t i) { return samples.value[i]; });
      }
    }
  }
}

const std::vector<std::array<double, 2>>& ContourCells::RangesAbout(const TileArea& area, int far)
{
  const auto width = static_cast<std::size_t>(area.Width());
  InRows.assign(width * static_cast<std::size_t>(Pixels.Height()), kNoRange);
  for (int y = Pixels.y0; y < Pixels.y1; ++y)
  {
    std::array<double, 2>* const row = &InRows[static_cast<std::size_t>(y - Pixels.y0) * width];
    for (int x = Pixels.x0; x < Pixels.x1; ++x)
    {
      if (LayerOf(x, y) == kNoLayer)
      {
        continue;
      }
      const auto [least, greatest] = std::ranges::minmax(Values[At(x, y)]);
      for (int to = std::max(x - far, area.x0); to <= std::min(x + far, area.x1 - 1); ++to)
      {
        Widen(row[to - area.x0], { least, greatest });
      }
    }
  }
  Ranges.assign(width * static_cast<std::size_t>(area.Height()), kNoRange);
  for (int y = Pixels.y0; y < Pixels.y1; ++y)
  {
    for (int to = std::max(y - far, area.y0); to <= std::min(y + far, area.y1 - 1); ++to)
    {
      for (std::size_t x = 0; x < width; ++x)
      {
        Widen(Ranges[static_cast<std::size_t>(to - area.y0) * width + x],
          InRows[static_cast<std::size_t>(y - Pixels.y0) * width + x]);
      }
    }
  }
  return Ranges;
}

ContourCells::Local ContourCells::Evaluate(int x, int y, const glm::dvec2& at) const
{
  const std::array<double, 4>& f = Values[At(x, y)];
  const double u = at.x - x;
  const double v = at.y - y;
  const double below = f[0] + u * (f[1] - f[0]);
  const double above = f[2] + u * (f[3] - f[2]);
  return { below + v * (above - below),
    { (1.0 - v) * (f[1] - f[0]) + v * (f[3] - f[2]), above - below } };
}

std::optional<double> ContourCells::ValueAt(const glm::dvec2& at) const
{
  const int x = static_cast<int>(std::floor(at.x));
  const int y = static_cast<int>(std::floor(at.y));
  return Holds(x, y) && LayerOf(x, y) != kNoLayer ? std::optional(Evaluate(x, y, at).value)
                                                  : std::nullopt;
}

std::optional<ContourFoot> ContourCells::Find(const glm::dvec2& from, double value, int far) const
{
  const int x = static_cast<int>(std::floor(from.x));
  const int y = static_cast<int>(std::floor(from.y));
  const std::uint8_t layer = Holds(x, y) ? LayerOf(x, y) : kNoLayer;
  glm::dvec2 at = from;
  for (int step = 0; step < far + kMoreSteps && layer != kNoLayer; ++step)
  {
    const int cx = static_cast<int>(std::floor(at.x));
    const int cy = static_cast<int>(std::floor(at.y));
    if (std::abs(cx - x) > far || std::abs(cy - y) > far || !Holds(cx, cy) ||
      LayerOf(cx, cy) != layer)
    {
      return std::nullopt;
    }
    const auto [here, gradient] = Evaluate(cx, cy, at);
    const double slope = glm::length(gradient);
    const double way = (value - here) / slope;
    if (!std::isfinite(way))
    {
      return std::nullopt;
    }
    const glm::dvec2 towards = gradient / slope;
    if (std::fabs(way) < kSettled)
    {
      return ContourFoot{ glm::dot(at - from, towards), towards };
    }
    // Where the field is nearly flat, the step overestimates the distance.
    at += std::clamp(way, -1.0, 1.0) * towards;
  }
  return std::nullopt;
}
} // namespace pixelexact
