// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <span>
#include <vector>

namespace pixelexact
{
class TileVisit;

/// Colours samples: colour map, lights, diagnostic pictures.
class SampleColors
{
public:
  virtual ~SampleColors() = default;

  /// The buffers that Paint reads.
  [[nodiscard]] virtual Buffer Needs() const = 0;

  /// Colours samples [begin, end) of one sheet: writes 4 bytes per sample to samples.color, which
  /// earlier SampleColors have written, and nothing else. Called from several threads at once. A
  /// sample's colour depends on that sample alone.
  virtual void Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const = 0;
};

/// The tiles of a frame that one of several processes traces: every `of`-th, from number `turn` on.
struct TileTurn
{
  int turn = 0;
  int of = 1;

  [[nodiscard]] bool Has(int tile) const { return tile % of == turn; }
};

/// The samples and buffers that a stage after the rays reads.
struct SampleNeeds
{
  Buffer centres = Buffer::None;
  /// Buffers of centres that make the stage faster. TileVisit::Centres has them for newly traced
  /// tiles; frames need not keep them.
  Buffer welcome = Buffer::None;
  Buffer corners = Buffer::None; ///< of the tile's pixels
  Buffer edges = Buffer::None;   ///< between the corners, see edgeLevel
  int edgeLevel = 0;             ///< an edge is cut into 2^edgeLevel parts; 0: no samples on edges
  bool coloredCorners = false;   ///< with all buffers that the pipeline's colours read
  bool wholeFrame = false; ///< tiles are visited after the preceding modules have visited all tiles

  TileTurn tiles{}; ///< of centres, in a call of Trace; the other tiles become Nothing

  void Add(const SampleNeeds& other);
  [[nodiscard]] bool BeyondCentres() const
  {
    return corners != Buffer::None || (edges != Buffer::None && edgeLevel > 0);
  }
};

/// A stage that changes the image after rays and colours (paper, section 5.1), as anti-aliasing and
/// contours do. It declares its needs. The tracer casts the union of all needs once, in one visit
/// of each tile.
class FrameModule
{
public:
  virtual ~FrameModule() = default;
  [[nodiscard]] virtual SampleNeeds Needs() const = 0;

  /// Called before a frame: allocates the module's own buffers for width x height pixels.
  virtual void Begin(int width, int height) = 0;

  /// Called once for each tile of pixels, while its samples are in cache, from several threads at
  /// once. Writes only entries of the tile's pixels. A pixel's result does not depend on tiles.
  virtual void Process(TileVisit& tile) = 0;

  /// A second pass over all tiles, after the module has visited all of them and before modules with
  /// SampleNeeds::wholeFrame. It may return a further pass. Its needs and Begin are those of this
  /// module. Null: there is no second pass.
  [[nodiscard]] virtual FrameModule* Rest() { return nullptr; }
};

/// Stages that process a tile with complete samples: colours in this order, blending of sheets,
/// modules in this order. The objects must outlive the pipeline.
struct Pipeline
{
  std::vector<const SampleColors*> colors;
  std::vector<FrameModule*> modules;

  /// The union of the buffers that the colours read.
  [[nodiscard]] Buffer ColorNeeds() const;
  /// The union of all needs.
  [[nodiscard]] SampleNeeds Needs() const;
  /// The runs of modules: those of a run process each tile one after the other, and each run visits
  /// all tiles. There is at least one run.
  [[nodiscard]] std::vector<std::vector<FrameModule*>> Runs() const;
};
} // namespace pixelexact
