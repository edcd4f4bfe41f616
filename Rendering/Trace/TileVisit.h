// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Pipeline.h"
#include "Trace/Scene.h"
#include "Trace/TraceTile.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Samples of a part of an image, row by row: of the pixel (x, y) its centre or, where they are
/// corners, the lower left one.
struct LatticePart
{
  const SampleBuffers& samples;
  int x0 = 0; ///< of the first
  int y0 = 0;

  [[nodiscard]] std::size_t At(int x, int y) const
  {
    return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(samples.width) +
      static_cast<std::size_t>(x - x0);
  }
};

/// What modules see of a tile, and what they may ask for.
class TileVisit
{
public:
  /// `scene` null: a frame that is there already gets other colours, and nothing can be traced.
  /// `own`: the area's centres, with more buffers than the frame keeps; null: there are none. It
  /// must outlive it.
  TileVisit(const Scene* scene, const Camera* camera, const Pipeline& pipeline, Frame& frame,
    const TileArea& area, const SampleBuffers* own = nullptr)
    : scene_(scene)
    , camera_(camera)
    , pipeline_(pipeline)
    , frame_(frame)
    , area_(area)
    , Own(own)
  {
  }

  /// Colours and the image.
  void MakeImage();
  void Run(std::span<FrameModule* const> modules);

  [[nodiscard]] const TileArea& Area() const { return area_; }
  /// The frame; of the area's pixels alone.
  [[nodiscard]] Frame& GetFrame() { return frame_; }

  /// What is traced, and from where. Throw Error where nothing can be traced.
  [[nodiscard]] const Scene& GetScene() const;
  [[nodiscard]] const Camera& GetCamera() const;

  /// The centres of the area's pixels with the buffers that the modules welcome; nothing where they
  /// are not at hand, as in frames that have been traced before and do not keep them.
  [[nodiscard]] std::optional<LatticePart> Centres() const;
  /// The corners of the area's pixels, (width + 1) x (height + 1), with the buffers that the
  /// modules need. Their colours are made by Image, if a module needs them coloured.
  [[nodiscard]] SampleBuffers& Corners();
  /// Some corners of a part of the lattice, which may reach beyond the tile: those that are wanted,
  /// row by row, with the buffers that are needed, of those that the modules need. Of others there
  /// is nothing, or what is seen there. `traced` must outlive it.
  [[nodiscard]] LatticePart CornersOf(const TileArea& lattice, std::span<const std::uint8_t> wanted,
    Buffer needed, SampleBuffers& traced);
  /// Samples within edges, so many for each edge (SampleNeeds::edgeLevel): those that go across,
  /// width x (height + 1) edges, and those that go up, (width + 1) x height; edge by edge, rows of
  /// edges lower-left first.
  [[nodiscard]] const SampleBuffers& EdgesAcross();
  [[nodiscard]] const SampleBuffers& EdgesUp();
  [[nodiscard]] int SamplesPerEdge() const;

  /// More samples, one after the other, as a row. Throws Error where nothing can be traced, as do
  /// those above.
  [[nodiscard]] SampleBuffers Trace(std::span<const ImagePosition> positions, Buffer wanted);

  /// The buffers that samples must have for Image.
  [[nodiscard]] Buffer ColorNeeds() const { return pipeline_.ColorNeeds(); }
  /// Colours of samples, the sheets blended: 4 bytes each.
  [[nodiscard]] std::vector<std::uint8_t> Image(SampleBuffers& samples) const;

  /// Of samples that were asked for here.
  [[nodiscard]] const FrameCounters& Counters() const { return Asked; }

private:
  void RequireTracing() const;
  /// Whether the frame has the corners that the modules need.
  [[nodiscard]] bool HasCorners() const;
  const SampleBuffers& Edges(SampleBuffers& samples, bool across);

  const Scene* scene_;
  const Camera* camera_;
  const Pipeline& pipeline_;
  Frame& frame_;
  TileArea area_;
  const SampleBuffers* Own;
  FrameCounters Asked;
  SampleBuffers AtCorners;
  SampleBuffers Across;
  SampleBuffers Up;
};

/// For each corner of some pixels, (width + 1) x (height + 1), whether it is one of a pixel that is
/// set; both row by row.
[[nodiscard]] std::vector<std::uint8_t> CornersOfPixels(
  std::span<const std::uint8_t> pixels, int width);

/// Colours of samples of one set, row by row from `begin`: those behind show through translucent
/// ones. `image` gets 4 bytes a sample.
void BlendSheets(
  const SampleBuffers& samples, std::size_t begin, std::size_t end, std::uint8_t* image);
} // namespace pixelexact
