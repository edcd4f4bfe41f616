// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/LineConvolution.h"

#include "Trace/Frame.h"
#include "Trace/Pipeline.h"
#include "Trace/Projection.h"
#include "Trace/Scene.h"
#include "Trace/TileVisit.h"

#include "Core/Location/Locator.h"
#include "Core/Location/Sample.h"

#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace pixelexact
{
namespace
{
/// Pixels of a streamline to each side of its seed, beyond those that are averaged.
constexpr int kServed = 60;
/// Seeds of one pass are this far apart in both directions.
constexpr int kSeedSpacing = 8;
constexpr std::size_t kVectorsPerBatch = 1024;
/// A step leaves the surface if it is so many times as long as the field's direction says, or
/// leaves the tangential plane by such a part of a pixel.
constexpr double kMaxStep = 4.0;
constexpr double kMaxOffset = 0.5;
/// Part of a vector that may remain of its tangential part by rounding where it is normal to the
/// surface.
constexpr double kVectorRounding = 1e-12;
/// Standard deviation of the texture.
constexpr double kDeviation = 0.22;

/// A position of a streamline.
struct StreamPoint
{
  ImagePosition at{};
  std::array<double, 2> direction{}; ///< of unit length, in pixels
  Vec3 x{ 0.0 };                     ///< on the surface
  Vec3 normal{ 0.0 };
  double pixel = 0.0;  ///< the length of a pixel there
  double stride = 0.0; ///< the length of a step of a pixel along the surface
  std::uint8_t layer = 0;
  bool isValid = false;
};

/// Evaluates directions at positions of the picture.
class StreamSampler
{
public:
  StreamSampler(
    const Scene& scene, const CameraView& view, int width, int height, const Field& field)
    : Traced(scene)
    , Rays(view, width, height)
    , Shown(field)
    , Parallel(view.parallel)
    , Eye(view.position)
    , Axes(AxesOf(view))
    , Pixels(view, width, height)
  {
    // Values of the layers are not needed.
    for (Layer& layer : Traced.layers)
    {
      layer.field = nullptr;
    }
  }

  /// Fills all members but `at`.
  void Evaluate(std::span<StreamPoint> points) const
  {
    tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, (points.size() + kVectorsPerBatch - 1) / kVectorsPerBatch),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t batch = range.begin(); batch < range.end(); ++batch)
        {
          const std::size_t first = batch * kVectorsPerBatch;
          EvaluateBatch(points.subspan(first, std::min(kVectorsPerBatch, points.size() - first)));
        }
      });
  }

private:
  void EvaluateBatch(std::span<StreamPoint> points) const
  {
    std::vector<ImagePosition> positions;
    positions.reserve(points.size());
    for (const StreamPoint& point : points)
    {
      positions.push_back(point.at);
    }
    Frame none;
    const Pipeline pipeline;
    TileVisit visit(&Traced, &Rays, pipeline, none, {});
    const SampleBuffers samples = visit.Trace(
      positions, Buffer::Position | Buffer::Normal | Buffer::Xi | Buffer::Element | Buffer::Layer);
    std::vector<std::size_t> order;
    order.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i].isValid = false;
      if (samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
      {
        order.push_back(i);
      }
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return samples.element[i]; });
    for (std::size_t begin = 0; begin < order.size();)
    {
      std::size_t end = begin + 1;
      while (end < order.size() && samples.element[order[end]] == samples.element[order[begin]])
      {
        ++end;
      }
      EvaluateElement(samples, std::span(order).subspan(begin, end - begin), points);
      begin = end;
    }
  }

  void EvaluateElement(const SampleBuffers& samples, std::span<const std::size_t> which,
    std::span<StreamPoint> points) const
  {
    std::vector<Vec3> xi;
    std::vector<Vec3> x;
    std::vector<Vec3> normals;
    xi.reserve(which.size());
    x.reserve(which.size());
    normals.reserve(which.size());
    for (const std::size_t i : which)
    {
      xi.push_back(samples.xi[i]);
      x.push_back(samples.position[i]);
      normals.push_back(samples.normal[i]);
    }
    const auto components = static_cast<std::size_t>(Shown.values.components);
    std::vector<double> values(components * which.size());
    EvaluateAt(Traced.locator->GetMesh(), Shown, static_cast<int>(samples.element[which.front()]),
      xi, values, {}, { x, normals });
    for (std::size_t k = 0; k < which.size(); ++k)
    {
      Vec3 vector(0.0);
      for (std::size_t c = 0; c < components; ++c)
      {
        vector[static_cast<int>(c)] = values[components * k + c];
      }
      StreamPoint& point = points[which[k]];
      point.layer = samples.layer[which[k]];
      point.normal = normals[k];
      const Vec3 tangent = vector - glm::dot(vector, normals[k]) * normals[k];
      SetDirection(x[k], tangent, kVectorRounding * glm::length(vector), point);
    }
  }

  /// `noise`: tangents that are no longer have no direction.
  void SetDirection(const Vec3& x, const Vec3& tangent, double noise, StreamPoint& point) const
  {
    const Vec3 way = x - Eye;
    const double depth = glm::dot(way, Axes.forward);
    point.x = x;
    point.pixel = Pixels.PixelAt(depth);
    // The derivative of the position in the picture along the tangent.
    const double farther = Parallel ? 0.0 : glm::dot(tangent, Axes.forward) / depth;
    const double across = glm::dot(tangent, Axes.right) - farther * glm::dot(way, Axes.right);
    const double up = glm::dot(tangent, Axes.up) - farther * glm::dot(way, Axes.up);
    const double length = std::hypot(across, up);
    point.isValid = length > 0.0 && std::isfinite(length) && glm::length(tangent) > noise;
    if (point.isValid)
    {
      point.direction = { across / length, up / length };
      point.stride = glm::length(tangent) * point.pixel / length;
    }
  }

  Scene Traced;
  Camera Rays;
  const Field& Shown;
  bool Parallel;
  Vec3 Eye;
  CameraAxes Axes;
  Projection Pixels;
};

/// A number from 0 to 1 that has no pattern over the pixels (finaliser of MurmurHash3, A. Appleby).
double NoiseAt(std::uint32_t pixel)
{
  std::uint32_t hash = pixel * 0x9e3779b9U + 0x7f4a7c15U;
  hash = (hash ^ hash >> 16U) * 0x85ebca6bU;
  hash = (hash ^ hash >> 13U) * 0xc2b2ae35U;
  hash ^= hash >> 16U;
  return hash / 4294967296.0;
}

/// The streamlines of one pass and the averages of all passes.
class Convolution
{
public:
  Convolution(const StreamSampler& sampler, int width, int height, int halfLength)
    : Sampler(sampler)
    , Width(width)
    , Height(height)
    , Half(halfLength)
    , Sums(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    , Counts(Sums.size())
  {
  }

  /// Integrates the streamlines of the seeds of a pass, at pixels that no line has reached.
  void Pass(int firstX, int firstY)
  {
    std::vector<StreamPoint> seeds;
    for (int y = firstY; y < Height; y += kSeedSpacing)
    {
      for (int x = firstX; x < Width; x += kSeedSpacing)
      {
        if (Counts[At(x, y)] == 0)
        {
          seeds.push_back({ .at = { x + 0.5, y + 0.5 } });
        }
      }
    }
    Evaluate(seeds);
    std::erase_if(seeds, [](const StreamPoint& seed) { return !seed.isValid; });
    Lines.assign(seeds.size(), {});
    Middle.resize(seeds.size());
    Integrate(seeds, -1.0);
    for (std::size_t k = 0; k < seeds.size(); ++k)
    {
      std::ranges::reverse(Lines[k]);
      Middle[k] = Lines[k].size();
      Lines[k].push_back(PixelOf(seeds[k].at));
    }
    Integrate(seeds, 1.0);
    for (std::size_t k = 0; k < seeds.size(); ++k)
    {
      Average(Lines[k], Middle[k]);
    }
  }

  [[nodiscard]] ConvolvedNoise Result() const
  {
    ConvolvedNoise noise;
    noise.samples = Samples;
    noise.values.assign(Sums.size(), std::numeric_limits<float>::quiet_NaN());
    // Averages of n numbers from 0 to 1 have a deviation of 1 / sqrt(12 n).
    const double factor = kDeviation * std::sqrt(12.0 * (2 * Half + 1));
    for (std::size_t i = 0; i < Sums.size(); ++i)
    {
      if (Counts[i] > 0)
      {
        noise.values[i] =
          static_cast<float>(std::clamp(0.5 + factor * (Sums[i] / Counts[i] - 0.5), 0.0, 1.0));
      }
    }
    return noise;
  }

private:
  using Line = std::vector<std::uint32_t>; ///< pixels

  [[nodiscard]] std::size_t At(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(Width) +
      static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool IsWithin(const ImagePosition& at) const
  {
    return at[0] >= 0.0 && at[1] >= 0.0 && at[0] < Width && at[1] < Height;
  }
  [[nodiscard]] std::uint32_t PixelOf(const ImagePosition& at) const
  {
    return static_cast<std::uint32_t>(At(static_cast<int>(at[0]), static_cast<int>(at[1])));
  }

  void Evaluate(std::vector<StreamPoint>& points)
  {
    Sampler.Evaluate(points);
    Samples += std::ssize(points);
  }

  /// Appends the pixels of the lines from the seeds, along the field or against it.
  void Integrate(const std::vector<StreamPoint>& seeds, double sign)
  {
    std::vector<StreamPoint> heads = seeds;
    std::vector<std::size_t> line(seeds.size());
    std::iota(line.begin(), line.end(), std::size_t{ 0 });
    std::vector<StreamPoint> next;
    for (int step = 0; step < kServed + Half && !heads.empty(); ++step)
    {
      next = heads;
      Advance(heads, heads, 0.5 * sign, next);
      const std::vector<StreamPoint> middles = next;
      Advance(heads, middles, sign, next);
      std::size_t kept = 0;
      for (std::size_t k = 0; k < heads.size(); ++k)
      {
        if (middles[k].isValid && next[k].isValid && IsOneStep(heads[k], next[k]))
        {
          Lines[line[k]].push_back(PixelOf(next[k].at));
          heads[kept] = next[k];
          line[kept++] = line[k];
        }
      }
      heads.resize(kept);
      line.resize(kept);
    }
  }

  /// Whether two points one pixel apart are on the same part of a surface.
  static bool IsOneStep(const StreamPoint& from, const StreamPoint& to)
  {
    const Vec3 way = to.x - from.x;
    return from.layer == to.layer &&
      glm::length(way) < kMaxStep * std::max(from.stride, to.stride) &&
      std::fabs(glm::dot(way, from.normal)) < kMaxOffset * from.pixel;
  }

  /// Moves from `from` by a length along the directions of `by`, and evaluates there.
  void Advance(const std::vector<StreamPoint>& from, const std::vector<StreamPoint>& by,
    double length, std::vector<StreamPoint>& to)
  {
    for (std::size_t k = 0; k < from.size(); ++k)
    {
      to[k].at = { from[k].at[0] + length * by[k].direction[0],
        from[k].at[1] + length * by[k].direction[1] };
    }
    Evaluate(to);
    for (StreamPoint& point : to)
    {
      point.isValid = point.isValid && IsWithin(point.at);
    }
  }

  /// Adds the averages over each part of a line of 2 * Half + 1 pixels to the pixel in its middle.
  void Average(const Line& line, std::size_t seed)
  {
    const auto count = std::ssize(line);
    std::vector<double> sums(line.size() + 1, 0.0);
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      sums[i + 1] = sums[i] + NoiseAt(line[i]);
    }
    const auto middle = static_cast<std::ptrdiff_t>(seed);
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(middle - kServed, 0);
         i < std::min<std::ptrdiff_t>(middle + kServed + 1, count); ++i)
    {
      const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(i - Half, 0);
      const std::ptrdiff_t end = std::min<std::ptrdiff_t>(i + Half + 1, count);
      const double sum =
        sums[static_cast<std::size_t>(end)] - sums[static_cast<std::size_t>(begin)];
      const std::uint32_t pixel = line[static_cast<std::size_t>(i)];
      Sums[pixel] += sum / static_cast<double>(end - begin);
      ++Counts[pixel];
    }
  }

  const StreamSampler& Sampler;
  int Width;
  int Height;
  int Half;
  std::vector<Line> Lines;
  std::vector<std::size_t> Middle; ///< place of the seed, by line
  std::vector<double> Sums;
  std::vector<std::uint32_t> Counts;
  std::int64_t Samples = 0;
};
} // namespace

ConvolvedNoise ConvolveNoise(const Scene& scene, const CameraView& view, int width, int height,
  const Field& field, int halfLength)
{
  const StreamSampler sampler(scene, view, width, height, field);
  Convolution convolution(sampler, width, height, halfLength);
  // Bits in reverse order spread the seeds of successive passes.
  constexpr std::array<int, kSeedSpacing> kOrder{ 0, 4, 2, 6, 1, 5, 3, 7 };
  for (const int y : kOrder)
  {
    for (const int x : kOrder)
    {
      convolution.Pass(x, y);
    }
  }
  return convolution.Result();
}
} // namespace pixelexact
