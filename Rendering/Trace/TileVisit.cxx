// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TileVisit.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/Error.h"
#include "Core/Base/StageClock.h"
#include "Trace/BufferTable.h"
#include "Trace/TraceTile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace pixelexact
{
namespace
{
/// Calls visit(samples) for each sheet.
template <class Visit>
void ForEachSheet(SampleBuffers& samples, const Visit& visit)
{
  visit(samples);
  for (SampleBuffers& sheet : samples.behind)
  {
    visit(sheet);
  }
}
} // namespace

void BlendSheets(
  const SampleBuffers& samples, std::size_t begin, std::size_t end, std::uint8_t* image)
{
  if (samples.behind.empty())
  {
    // One opaque sheet needs no blending. Empty samples get no colour. Whole pixels are compared,
    // several at once.
    constexpr auto kAlpha =
      std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{ 0, 0, 0, 255 });
    const std::uint8_t* own = samples.color.data() + 4 * begin;
    for (std::size_t i = begin; i < end; ++i, own += 4, image += 4)
    {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, own, sizeof(pixel));
      pixel = (pixel & kAlpha) != 0 ? pixel : 0;
      std::memcpy(image, &pixel, sizeof(pixel));
    }
    return;
  }
  for (std::size_t i = begin; i < end; ++i, image += 4)
  {
    // Blends front to back, with straight alpha.
    double color[3] = {};
    double through = 1.0;
    const auto add = [&](const SampleBuffers& sheet)
    {
      const std::uint8_t* own = &sheet.color[4 * i];
      const double share = through * own[3] / 255.0;
      for (int c = 0; c < 3; ++c)
      {
        color[c] += share * own[c];
      }
      through -= share;
    };
    add(samples);
    for (const SampleBuffers& sheet : samples.behind)
    {
      add(sheet);
    }
    const double alpha = 1.0 - through;
    for (int c = 0; c < 3; ++c)
    {
      image[c] = alpha > 0.0 ? static_cast<std::uint8_t>(std::lround(color[c] / alpha)) : 0;
    }
    image[3] = static_cast<std::uint8_t>(std::lround(255.0 * alpha));
  }
}

void TileVisit::Run(std::span<FrameModule* const> modules)
{
  for (FrameModule* module : modules)
  {
    const StageScope scope(Stage::Modules);
    module->Process(*this);
  }
}

void TileVisit::MakeImage()
{
  if (pipeline_.colors.empty())
  {
    return;
  }
  const StageScope scope(Stage::Modules);
  const auto width = static_cast<std::size_t>(frame_.width);
  const auto inRow = static_cast<std::size_t>(area_.Width());
  for (int y = area_.y0; y < area_.y1; ++y)
  {
    const std::size_t begin =
      static_cast<std::size_t>(y) * width + static_cast<std::size_t>(area_.x0);
    ForEachSheet(frame_.centres,
      [&](SampleBuffers& sheet)
      {
        for (const auto* painter : pipeline_.colors)
        {
          painter->Paint(sheet, begin, begin + inRow);
        }
      });
    if (!frame_.color.empty())
    {
      BlendSheets(frame_.centres, begin, begin + inRow, &frame_.color[4 * begin]);
    }
  }
}

std::vector<std::uint8_t> TileVisit::Image(SampleBuffers& samples) const
{
  ForEachSheet(samples,
    [&](SampleBuffers& sheet)
    {
      sheet.color.assign(4 * sheet.Size(), 0);
      for (const auto* painter : pipeline_.colors)
      {
        painter->Paint(sheet, 0, sheet.Size());
      }
    });
  std::vector<std::uint8_t> image(4 * samples.Size());
  BlendSheets(samples, 0, samples.Size(), image.data());
  return image;
}

void TileVisit::RequireTracing() const
{
  if (scene_ == nullptr || camera_ == nullptr)
  {
    throw Error("a module asks for the scene of a frame that only gets other colours; trace it");
  }
}

const Scene& TileVisit::GetScene() const
{
  RequireTracing();
  return *scene_;
}

const Camera& TileVisit::GetCamera() const
{
  RequireTracing();
  return *camera_;
}

SampleBuffers TileVisit::Trace(std::span<const ImagePosition> positions, Buffer wanted)
{
  RequireTracing();
  SampleBuffers samples;
  samples.Allocate(wanted | Buffer::Verdict, static_cast<int>(positions.size()), 1);
  const CheckedOut<TileSamples> tile;
  (*tile).Begin(*camera_, positions);
  Sheets sheets(samples, wanted | Buffer::Verdict);
  TraceTile(*scene_, *camera_, *tile, sheets, Asked);
  return samples;
}

bool TileVisit::HasCorners() const
{
  return frame_.corners.Holds(pipeline_.Needs().corners);
}

namespace
{
/// Copies the samples of `area` of a lattice, sheet by sheet.
void CopyPart(const LatticePart& from, const TileArea& area, SampleBuffers& to)
{
  const auto copy = [&](const SampleBuffers& source, SampleBuffers& part)
  {
    ForEachBuffer(
      [&](const auto& row)
      {
        const auto& values = source.*row.member;
        for (int y = area.y0; y < area.y1 && !values.empty(); ++y)
        {
          const auto* const first = values.data() + from.At(area.x0, y);
          (part.*row.member).insert((part.*row.member).end(), first, first + area.Width());
        }
      });
    part.width = area.Width();
    part.height = area.Height();
  };
  to = {};
  copy(from.samples, to);
  for (const SampleBuffers& sheet : from.samples.behind)
  {
    copy(sheet, to.behind.emplace_back());
  }
}
} // namespace

SampleBuffers& TileVisit::Corners()
{
  if (AtCorners.Size() > 0)
  {
    return AtCorners;
  }
  const TileArea lattice{ area_.x0, area_.y0, area_.x1 + 1, area_.y1 + 1 };
  if (HasCorners())
  {
    CopyPart({ frame_.corners }, lattice, AtCorners);
    return AtCorners;
  }
  RequireTracing();
  const Buffer wanted = pipeline_.Needs().corners;
  AtCorners.Allocate(wanted, lattice.Width(), lattice.Height());
  Sheets sheets(AtCorners, wanted);
  const CheckedOut<TileSamples> tile;
  (*tile).BeginAlone(*camera_, lattice, 0.0);
  TraceTile(*scene_, *camera_, *tile, sheets, Asked);
  return AtCorners;
}

std::optional<LatticePart> TileVisit::Centres() const
{
  const Buffer wanted = pipeline_.Needs().welcome;
  if (frame_.centres.Holds(wanted))
  {
    return LatticePart{ frame_.centres };
  }
  if (Own && Own->Holds(wanted))
  {
    return LatticePart{ *Own, area_.x0, area_.y0 };
  }
  return std::nullopt;
}

std::vector<std::uint8_t> CornersOfPixels(std::span<const std::uint8_t> pixels, int width)
{
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t across = columns + 1;
  std::vector<std::uint8_t> corners(across * (pixels.size() / columns + 1), 0);
  for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel)
  {
    if (pixels[pixel] != 0)
    {
      const std::size_t corner = pixel / columns * across + pixel % columns;
      corners[corner] = corners[corner + 1] = corners[corner + across] =
        corners[corner + across + 1] = 1;
    }
  }
  return corners;
}

LatticePart TileVisit::CornersOf(const TileArea& lattice, std::span<const std::uint8_t> wanted,
  Buffer needed, SampleBuffers& traced)
{
  if (HasCorners())
  {
    return { frame_.corners };
  }
  RequireTracing();
  std::vector<ImagePosition> positions;
  std::vector<std::size_t> places;
  // Positions are ordered in blocks, so that neighbours follow each other.
  constexpr int kBlock = TileSamples::kRow;
  const auto width = static_cast<std::size_t>(lattice.Width());
  for (int y0 = lattice.y0; y0 < lattice.y1; y0 += kBlock)
  {
    for (int x0 = lattice.x0; x0 < lattice.x1; x0 += kBlock)
    {
      for (int y = y0; y < std::min(y0 + kBlock, lattice.y1); ++y)
      {
        for (int x = x0; x < std::min(x0 + kBlock, lattice.x1); ++x)
        {
          const std::size_t place = static_cast<std::size_t>(y - lattice.y0) * width +
            static_cast<std::size_t>(x - lattice.x0);
          if (wanted[place] != 0)
          {
            positions.push_back({ static_cast<double>(x), static_cast<double>(y) });
            places.push_back(place);
          }
        }
      }
    }
  }
  const SampleBuffers some = Trace(positions, needed);
  traced.Allocate(needed, lattice.Width(), lattice.Height());
  ForEachBuffer(
    [&](const auto& row)
    {
      const auto& from = some.*row.member;
      auto& to = traced.*row.member;
      for (std::size_t i = 0; i < places.size() && !to.empty(); ++i)
      {
        to[places[i]] = from[i];
      }
    });
  return { traced, lattice.x0, lattice.y0 };
}

int TileVisit::SamplesPerEdge() const
{
  const SampleNeeds needs = pipeline_.Needs();
  return needs.edges == Buffer::None ? 0 : (1 << needs.edgeLevel) - 1;
}

const SampleBuffers& TileVisit::EdgesAcross()
{
  return Edges(Across, true);
}

const SampleBuffers& TileVisit::EdgesUp()
{
  return Edges(Up, false);
}

const SampleBuffers& TileVisit::Edges(SampleBuffers& samples, bool across)
{
  const int inEdge = SamplesPerEdge();
  if (samples.Size() == 0 && inEdge > 0)
  {
    std::vector<ImagePosition> positions;
    for (int y = area_.y0; y < area_.y1 + (across ? 1 : 0); ++y)
    {
      for (int x = area_.x0; x < area_.x1 + (across ? 0 : 1); ++x)
      {
        for (int k = 1; k <= inEdge; ++k)
        {
          const double part = static_cast<double>(k) / (inEdge + 1);
          positions.push_back({ x + (across ? part : 0.0), y + (across ? 0.0 : part) });
        }
      }
    }
    samples = Trace(positions, pipeline_.Needs().edges);
  }
  return samples;
}
} // namespace pixelexact
