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
/// Samples of a part of an image, row by row. The sample of pixel (x, y) is at its centre or, in a
/// lattice of corners, at its lower left corner.
struct LatticePart
{
  const SampleBuffers& samples;
  int x0 = 0; ///< of the first sample
  int y0 = 0;

  [[nodiscard]] std::size_t At(int x, int y) const
  {
    return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(samples.width) +
      static_cast<std::size_t>(x - x0);
  }
};

/// Access of modules to a tile and to its samples.
class TileVisit
{
public:
  /// `scene` null: a complete frame gets other colours, and nothing can be traced. `own`: the
  /// area's centres, with more buffers than the frame keeps; null: there are none. Arguments must
  /// outlive the object.
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

  /// Makes the colours of samples, and the image.
  void MakeImage();
  void Run(std::span<FrameModule* const> modules);

  [[nodiscard]] const TileArea& Area() const { return area_; }
  /// The frame; only the area's pixels may be read or written.
  [[nodiscard]] Frame& GetFrame() { return frame_; }

  /// The traced scene and its camera. Throw Error if nothing can be traced.
  [[nodiscard]] const Scene& GetScene() const;
  [[nodiscard]] const Camera& GetCamera() const;

  /// The centres of the area's pixels with the buffers that the modules welcome; none if the frame
  /// does not hold these buffers, as after an earlier trace.
  [[nodiscard]] std::optional<LatticePart> Centres() const;
  /// The corners of the area's pixels, (width + 1) x (height + 1), with the buffers that the
  /// modules need. If a module needs colours of corners, Image makes them.
  [[nodiscard]] SampleBuffers& Corners();
  /// Corners of `lattice`, which may extend outside the tile. Corners with `wanted` set, row by
  /// row, hold the buffers `needed`, which must be among the modules' needs. Other corners hold
  /// Nothing or their sample. `traced` must outlive the result.
  [[nodiscard]] LatticePart CornersOf(const TileArea& lattice, std::span<const std::uint8_t> wanted,
    Buffer needed, SampleBuffers& traced);
  /// Samples inside edges, SamplesPerEdge() for each edge (SampleNeeds::edgeLevel). EdgesAcross has
  /// width x (height + 1) horizontal edges, EdgesUp (width + 1) x height vertical ones. Samples are
  /// stored edge by edge, edges in rows from the lower left.
  [[nodiscard]] const SampleBuffers& EdgesAcross();
  [[nodiscard]] const SampleBuffers& EdgesUp();
  [[nodiscard]] int SamplesPerEdge() const;

  /// Traces samples at any positions, in one row. Throws Error if nothing can be traced, as the
  /// functions above.
  [[nodiscard]] SampleBuffers Trace(std::span<const ImagePosition> positions, Buffer wanted);

  /// The buffers that samples must have for Image.
  [[nodiscard]] Buffer ColorNeeds() const { return pipeline_.ColorNeeds(); }
  /// Colours of samples, with sheets blended: 4 bytes each.
  [[nodiscard]] std::vector<std::uint8_t> Image(SampleBuffers& samples) const;

  /// Counters of the samples that modules requested from this object.
  [[nodiscard]] const FrameCounters& Counters() const { return Asked; }

private:
  void RequireTracing() const;
  /// The frame holds the corners that the modules need.
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

/// Marks the corners of pixels that are set. `pixels`: row by row. The result has (width + 1) x
/// (height + 1) corners, row by row.
[[nodiscard]] std::vector<std::uint8_t> CornersOfPixels(
  std::span<const std::uint8_t> pixels, int width);

/// Blends the sheets of samples [begin, end), front to back. `image` gets 4 bytes a sample.
void BlendSheets(
  const SampleBuffers& samples, std::size_t begin, std::size_t end, std::uint8_t* image);
} // namespace pixelexact
