// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <span>
#include <vector>

namespace pixelexact
{
class TileVisit;

/// Gives samples their colours: colour map, lights, pictures of soundness.
class SampleColors
{
public:
  virtual ~SampleColors() = default;

  /// The buffers that it reads.
  [[nodiscard]] virtual Buffer Needs() const = 0;

  /// Colours samples [begin, end) of one sheet: writes 4 bytes each of samples.color, which those
  /// before it have written, and nothing else. Called from several threads at once; what a sample
  /// gets depends on that sample alone.
  virtual void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const = 0;
};

/// Which of a frame's tiles one process of several traces: every `of`-th.
struct TileTurn
{
  int turn = 0;
  int of = 1;

  [[nodiscard]] bool Has(int tile) const { return tile % of == turn; }
};

/// The samples and buffers that something after the rays needs.
struct SampleNeeds
{
  Buffer centres = Buffer::None;
  /// Of centres: it is faster where they are there. New tiles have them for TileVisit::Centres,
  /// frames need not keep them.
  Buffer welcome = Buffer::None;
  Buffer corners = Buffer::None; ///< of the tile's pixels
  Buffer edges = Buffer::None;   ///< between the corners, see edgeLevel
  int edgeLevel = 0;             ///< an edge is cut into 2^edgeLevel parts; 0: no samples on edges
  bool coloredCorners = false;   ///< with all that the pipeline's colours read
  bool wholeFrame = false; ///< tiles are visited when the modules before it have seen them all

  TileTurn tiles{}; ///< of centres, in a call of Trace; the other tiles come back as Nothing

  void Add(const SampleNeeds& other);
  [[nodiscard]] bool BeyondCentres() const
  {
    return corners != Buffer::None || (edges != Buffer::None && edgeLevel > 0);
  }
};

/// Whatever works on the image after rays and colours (paper, section 5.1): anti-aliasing,
/// contours. It says what it needs; the tracer casts the union of all needs, once, in one visit of
/// a tile.
class FrameModule
{
public:
  virtual ~FrameModule() = default;
  [[nodiscard]] virtual SampleNeeds Needs() const = 0;

  /// Before a frame: makes buffers of its own for so many pixels.
  virtual void Begin(int width, int height) = 0;

  /// Once for each tile of pixels, while its samples are in cache. Called from several threads at
  /// once; writes entries of the tile's pixels alone. What a pixel gets does not depend on tiles.
  virtual void Process(TileVisit& tile) = 0;

  /// What it does with each tile once more, when it has seen them all and before modules that wait
  /// for that (SampleNeeds::wholeFrame), and what that does once more; their needs and Begin are
  /// those of this one. Null: nothing.
  [[nodiscard]] virtual FrameModule* Rest() { return nullptr; }
};

/// What happens to a tile when its samples are known: colours, in this order; the sheets become one
/// image; modules, in this order. What is pointed to must outlive it.
struct Pipeline
{
  std::vector<const SampleColors*> colors;
  std::vector<FrameModule*> modules;

  /// What the colours read.
  [[nodiscard]] Buffer ColorNeeds() const;
  /// The union of all needs.
  [[nodiscard]] SampleNeeds Needs() const;
  /// The modules that visit all tiles together, one after the other in each; one run at least.
  [[nodiscard]] std::vector<std::vector<FrameModule*>> Runs() const;
};
} // namespace pixelexact
