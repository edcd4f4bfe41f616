// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Volume/Volume.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Core/Math/Rounding.h"
#include "Trace/Rays.h"
#include "Trace/Scene.h"
#include "Trace/TileVisit.h"
#include "Trace/Volume/RayIntegral.h"
#include "Trace/Volume/RaySpans.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
/// The part of the leaves' tolerances that a second pass may use.
constexpr double kSharper = 1.0 / 64.0;

/// A surface's sample in front of, in or behind the volume.
struct SurfaceSample
{
  double t;
  std::array<double, 3> rgb;
  double alpha;
};

SurfaceSample SampleOf(double t, const std::uint8_t* rgba)
{
  return { t, { rgba[0] / 255.0, rgba[1] / 255.0, rgba[2] / 255.0 }, rgba[3] / 255.0 };
}

/// The samples of a pixel, front to back, up to the first opaque one.
void FindSamples(const Frame& frame, std::size_t pixel, std::vector<SurfaceSample>& samples)
{
  samples.clear();
  const SampleBuffers& centres = frame.centres;
  if (centres.behind.empty())
  {
    // The image may have lines in addition to the sheet's own colour.
    const std::uint8_t* rgba = &frame.color[4 * pixel];
    if (rgba[3] > 0)
    {
      samples.push_back(SampleOf(centres.depth[pixel], rgba));
    }
    return;
  }
  const auto add = [&](const SampleBuffers& sheet)
  {
    const std::uint8_t* rgba = &sheet.color[4 * pixel];
    if (rgba[3] > 0)
    {
      samples.push_back(SampleOf(sheet.depth[pixel], rgba));
    }
    return rgba[3] < 255;
  };
  bool isOpen = add(centres);
  for (std::size_t k = 0; k < centres.behind.size() && isOpen; ++k)
  {
    isOpen = add(centres.behind[k]);
  }
}

/// The part of a ray in all of the half-spaces that are kept.
VolumeRay MakeRay(const Ray& ray, const Scene& scene)
{
  VolumeRay made{ ray, 0.0, kFarthest };
  for (const auto& [a, b, c, d] : scene.kept)
  {
    const Vec3 normal(a, b, c);
    const double at = glm::dot(normal, ray.origin) + d;
    const double slope = glm::dot(normal, ray.direction);
    if (slope > 0.0)
    {
      made.tNear = std::max(made.tNear, -at / slope);
    }
    else if (slope < 0.0)
    {
      made.tFar = std::min(made.tFar, -at / slope);
    }
    else if (!(at >= 0.0))
    {
      made.tFar = -1.0;
    }
  }
  return made;
}

/// One pixel's volume with its surfaces.
class PixelVolume
{
public:
  PixelVolume(RayIntegral& integral, std::span<const SurfaceSample> samples)
    : Integral(integral)
    , Samples(samples)
  {
  }

  /// Returns whether everything that is visible is proven but for the integral's error.
  bool Run(const RaySpans& spans, std::size_t ray)
  {
    const std::span<const RaySpan> all = spans.Of(ray);
    double length = 0.0;
    for (const RaySpan& span : all)
    {
      length += span.to - span.from;
    }
    Integral.Begin(length);
    double last = -kInfinity;
    double lastError = 0.0;
    bool isProven = true;
    for (const RaySpan& span : all)
    {
      // Neighbours share a face; where they overlap by more than its uncertainty the mesh folds.
      const double slack = (lastError + span.fromError) * (1.0 + 1e-9) +
        16.0 * kUnitRoundoff * (std::fabs(last) + std::fabs(span.middle));
      isProven = isProven && !(last > span.from + slack);
      AddSamplesTo(span.from);
      if (Integral.IsDark())
      {
        return isProven;
      }
      isProven = isProven && span.isProven;
      const double* series = spans.Series(span);
      // Where neighbours meet, either of them may have the matter.
      const bool meets = last + lastError >= span.from - span.fromError;
      Integral.AddUncertainEnd(span, series, span.from, span.fromError + (meets ? lastError : 0.0));
      AddSpan(span, series, std::max(span.from, last));
      Integral.AddUncertainEnd(span, series, span.to, span.toError);
      if (span.to >= last)
      {
        last = span.to;
        lastError = span.toError;
      }
    }
    AddSamplesTo(kInfinity);
    return isProven;
  }

private:
  /// Adds the surfaces up to t.
  void AddSamplesTo(double t)
  {
    for (; Next < Samples.size() && Samples[Next].t <= t; ++Next)
    {
      Integral.AddLayer(Samples[Next].rgb, Samples[Next].alpha);
    }
  }

  void AddSpan(const RaySpan& span, const double* series, double from)
  {
    while (from < span.to && !Integral.IsDark())
    {
      AddSamplesTo(from);
      const double to = Next < Samples.size() ? std::min(span.to, Samples[Next].t) : span.to;
      if (!Integral.Add(span, series, from, to))
      {
        return;
      }
      from = to;
    }
  }

  RayIntegral& Integral;
  std::span<const SurfaceSample> Samples;
  std::size_t Next = 0;
};

std::uint8_t ToByte(double share)
{
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// Writes straight colour bytes.
void WriteColor(const RayIntegral& integral, std::uint8_t* rgba)
{
  const double alpha = integral.Opacity();
  for (std::size_t c = 0; c < 3; ++c)
  {
    rgba[c] = alpha > 0.0 ? ToByte(integral.Color()[c] / alpha) : 0;
  }
  rgba[3] = ToByte(alpha);
}
} // namespace

void RequireTraceable(const Volume& volume)
{
  if (volume.field == nullptr || volume.transfer == nullptr)
  {
    throw Error("volume: it needs a field and a transfer function; set both");
  }
  const Field& field = *volume.field;
  RequirePolynomials(field, "a volume");
  if (field.mapping != Mapping::Identity)
  {
    throw Unsupported("volume: values of field '" + field.name +
      "' are no polynomials of an element, because its kind (H(curl), H(div) or density) needs "
      "the map's derivatives; choose a field with plain values");
  }
  const int components = field.values.components;
  if (volume.component != kMagnitude && (volume.component < 0 || volume.component >= components))
  {
    throw Error("volume: field '" + field.name + "' has no component " +
      std::to_string(volume.component) + "; it has " + std::to_string(components) +
      ", counted from 0");
  }
  if (volume.component == kMagnitude && components > 9)
  {
    throw Unsupported("volume: the magnitude of field '" + field.name +
      "' has more than 9 components; choose one of them");
  }
}

VolumeDrawing::VolumeDrawing(Volume volume)
  : volume_(std::move(volume))
{
  RequireTraceable(volume_);
  magnitude_ = volume_.component == kMagnitude && volume_.field->values.components > 1;
}

VolumeDrawing::~VolumeDrawing() = default;

SampleNeeds VolumeDrawing::Needs() const
{
  return { .centres = Buffer::Depth | Buffer::Verdict };
}

void VolumeDrawing::Begin(int /*width*/, int /*height*/)
{
  proven_ = 0;
  unproven_ = 0;
  largest_ = 0.0;
}

const VolumeLeaves& VolumeDrawing::LeavesOf(const Scene& scene) const
{
  const std::scoped_lock lock(making_);
  const ElementIndex& index = scene.locator->Index();
  if (!leaves_ || &leaves_->Index() != &index)
  {
    const Box3& box = index.Bounds();
    const double diagonal = glm::length(box.upper - box.lower);
    const TransferFunction& transfer = *volume_.transfer;
    // The integral's error is about that of u times the steepness times the visible part of the
    // path, a few units, and that of places times the visible optical depth.
    const double units = 1.0 + std::min(1.0, diagonal / transfer.Unit());
    const double value =
      transfer.Steepness() > 0.0 ? kVolumeTolerance / 4.0 / (transfer.Steepness() * units) : 1e300;
    leaves_ = std::make_shared<VolumeLeaves>(index, *volume_.field,
      magnitude_ ? 0 : std::max(0, volume_.component),
      magnitude_ ? volume_.field->values.components : 1,
      VolumeLeaves::Tolerances{ value, kVolumeTolerance / 16.0 });
  }
  return *leaves_;
}

void VolumeDrawing::Process(TileVisit& tile)
{
  Frame& frame = tile.GetFrame();
  if (frame.color.empty())
  {
    return;
  }
  const Scene& scene = tile.GetScene();
  const VolumeLeaves& leaves = LeavesOf(scene);
  const TileArea& area = tile.Area();
  std::vector<VolumeRay> rays;
  std::vector<SurfaceSample> samples;
  rays.reserve(static_cast<std::size_t>(area.Width()) * static_cast<std::size_t>(area.Height()));
  const auto pixelOf = [&frame](int x, int y)
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
      static_cast<std::size_t>(x);
  };
  for (int y = area.y0; y < area.y1; ++y)
  {
    for (int x = area.x0; x < area.x1; ++x)
    {
      VolumeRay& ray = rays.emplace_back(MakeRay(tile.GetCamera().At(x + 0.5, y + 0.5), scene));
      FindSamples(frame, pixelOf(x, y), samples);
      if (!samples.empty() && samples.back().alpha >= 1.0)
      {
        ray.tFar = std::min(ray.tFar, samples.back().t);
      }
    }
  }
  std::int64_t proven = 0;
  double largest = 0.0;
  RaySpans spans(leaves);
  RayIntegral integral(*volume_.transfer, leaves.Components(), magnitude_);
  // Pixels whose bound is too large get a second pass with sharper interpolants.
  for (const double part : { 1.0, kSharper })
  {
    spans.Find(rays, part, volume_.transfer->LargestTau());
    bool isAnyOpen = false;
    std::size_t ray = 0;
    for (int y = area.y0; y < area.y1; ++y)
    {
      for (int x = area.x0; x < area.x1; ++x, ++ray)
      {
        if (rays[ray].isDone)
        {
          continue;
        }
        const std::size_t pixel = pixelOf(x, y);
        FindSamples(frame, pixel, samples);
        const bool isKnown = PixelVolume(integral, samples).Run(spans, ray) && !spans.HasLost(ray);
        const bool isProven = isKnown && integral.Error() <= kVolumeTolerance;
        if (isKnown && !isProven && part > kSharper)
        {
          isAnyOpen = true;
          continue;
        }
        rays[ray].isDone = true;
        const double bound = isKnown ? 255.0 * integral.Error() : kInfinity;
        proven += isProven ? 1 : 0;
        largest = isProven ? std::max(largest, bound) : largest;
        WriteColor(integral, &frame.color[4 * pixel]);
        if (!frame.centres.volumeBound.empty())
        {
          const auto& color = integral.Color();
          frame.centres.volumeColor[pixel] = { color[0], color[1], color[2] };
          frame.centres.volumeOpacity[pixel] = integral.Opacity();
          frame.centres.volumeBound[pixel] = bound;
        }
      }
    }
    if (!isAnyOpen)
    {
      break;
    }
  }
  proven_ += proven;
  unproven_ += static_cast<std::int64_t>(rays.size()) - proven;
  double before = largest_;
  while (before < largest && !largest_.compare_exchange_weak(before, largest))
  {
  }
}

VolumeCounters VolumeDrawing::Counters() const
{
  return { proven_, unproven_, largest_ };
}
} // namespace pixelexact
