// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/StageClock.h"
#include "Trace/Pipeline.h"
#include "Trace/Reporter.h"
#include "Trace/Scene.h"
#include "Trace/TraceTile.h"
#include "Trace/Tracer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Loops over the tiles of a frame, in parallel: they trace samples, and run a pipeline's colours
// and modules.
namespace pixelexact
{
/// Throws Error for a scene without locator or layers, a layer without surface or field, a
/// component out of range, too many layers, or enclosures of values in single precision.
void RequireTraceable(const Scene& scene, const SampleNeeds& needs);

/// By tile, row by row: 1 where it is done.
using TilesDone = std::vector<std::uint8_t>;

/// The corners of pixels.
inline constexpr SampleLattice kCorners{ 0.0 };

/// Tiles of a lattice over width x height samples.
int TilesOf(const SampleLattice& lattice, int width, int height);

/// What a tile does when its samples are written. `own`: TileVisit's.
using AfterTile =
  std::function<void(const TileArea& area, const SampleBuffers* own, FrameCounters& counters)>;

/// What else is done with the tiles of a lattice.
struct LatticeWork
{
  AfterTile after{}; ///< may be empty
  /// Buffers that `after` has beside those of the sheets: of the lattice of all centres, and of
  /// scenes with one sheet.
  Buffer passing = Buffer::None;
  TileTurn turn{}; ///< samples of the tiles that are another's are counted as nothing
  /// Null, or with as many entries as there are tiles: those that are set are left out, and set
  /// when they are done.
  TilesDone* done = nullptr;
};

/// Traces the samples of a lattice over the sheets' samples, or of a packed one as many as they
/// have; aborted tiles are left out. `stages` may be null.
FrameCounters TraceLattice(const Scene& scene, const Camera& camera, const SampleLattice& lattice,
  Sheets& sheets, Reporter& reporter, StageTimes* stages, const LatticeWork& work = {});

/// Before a pipeline runs over a frame whose sheets are there: its modules' own buffers, and room
/// for colours.
void BeginPipeline(const Pipeline& pipeline, Frame& frame);

/// Gives a tile its colours, image and what `modules`, the first of Pipeline::Runs, make of it.
/// Samples that they ask for are counted. `own`: TileVisit's.
void BeginPipelineOn(const TileArea& area, const SampleBuffers* own, const Scene& scene,
  const Camera& camera, const Pipeline& pipeline, std::span<FrameModule* const> modules,
  Frame& frame, FrameCounters& counters);
/// The runs of modules after that one, over all tiles until `reporter` has no time; returns what
/// was counted.
FrameCounters FinishPipeline(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  Frame& frame, Reporter& reporter, StageTimes* stages);

/// Runs the pipeline over all tiles of a frame whose samples are there; scene and camera may be
/// null (TileVisit), and so may the reporter. Returns what was counted of samples that modules
/// asked for.
FrameCounters RunPipeline(const Scene* scene, const Camera* camera, const Pipeline& pipeline,
  Frame& frame, Reporter* reporter = nullptr, StageTimes* stages = nullptr);

/// One of Pipeline::Runs over the tiles that are not done; BeginPipeline comes before the first.
FrameCounters RunPipelinePart(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  std::size_t run, Frame& frame, Reporter& reporter, TilesDone& done);

/// Adds what was counted; seconds are left alone.
void AddCounters(const FrameCounters& counted, FrameCounters& total);
/// Of samples that are no pixels' centres: rays and floats alone.
void AddSamples(const FrameCounters& counted, FrameCounters& total);
} // namespace pixelexact
