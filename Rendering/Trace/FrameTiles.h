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

// Loops over the tiles of a frame, in parallel. They trace samples and run a pipeline's colours and
// modules.
namespace pixelexact
{
/// Throws Error for a scene without locator or layers, a layer without surface or field, a
/// component out of range, more than Scene::kMaxLayers layers, or enclosures of values in single
/// precision.
void RequireTraceable(const Scene& scene, const SampleNeeds& needs);

/// Per tile, row by row: 1 if the tile is done.
using TilesDone = std::vector<std::uint8_t>;

/// The lattice of pixels' corners.
inline constexpr SampleLattice kCorners{ 0.0 };

/// Count of tiles of a lattice over width x height samples.
int TilesOf(const SampleLattice& lattice, int width, int height);

/// Runs after a tile's samples have been written. `own`: see TileVisit.
using AfterTile =
  std::function<void(const TileArea& area, const SampleBuffers* own, FrameCounters& counters)>;

/// Options of TraceLattice.
struct LatticeWork
{
  AfterTile after{}; ///< may be empty
  /// Buffers that `after` gets in addition to those of the sheets. Only for the lattice of all
  /// centres, and for scenes with one sheet.
  Buffer passing = Buffer::None;
  TileTurn turn{}; ///< samples of other processes' tiles are counted as Nothing
  /// One entry per tile: tiles that are set are omitted, and each completed tile is set. Null: all
  /// tiles are traced.
  TilesDone* done = nullptr;
};

/// Traces a lattice's samples and writes them to `sheets`. The lattice covers all samples of the
/// sheets or, if packed, has as many samples as they have. Aborted tiles are omitted. `stages` may
/// be null.
FrameCounters TraceLattice(const Scene& scene, const Camera& camera, const SampleLattice& lattice,
  Sheets& sheets, Reporter& reporter, StageTimes* stages, const LatticeWork& work = {});

/// Prepares a pipeline's run over a frame with complete sheets: allocates colours and calls the
/// modules' Begin.
void BeginPipeline(const Pipeline& pipeline, Frame& frame);

/// Makes a tile's colours and image, and runs `modules`, the first of Pipeline::Runs. Counts the
/// samples that modules request. `own`: see TileVisit.
void BeginPipelineOn(const TileArea& area, const SampleBuffers* own, const Scene& scene,
  const Camera& camera, const Pipeline& pipeline, std::span<FrameModule* const> modules,
  Frame& frame, FrameCounters& counters);
/// Runs the remaining runs of modules over all tiles until `reporter` has no time. Returns the
/// counters.
FrameCounters FinishPipeline(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  Frame& frame, Reporter& reporter, StageTimes* stages);

/// Runs the pipeline over all tiles of a frame with complete samples. `scene` and `camera` may be
/// null (TileVisit), and so may `reporter`. Returns the counters of samples that modules requested.
FrameCounters RunPipeline(const Scene* scene, const Camera* camera, const Pipeline& pipeline,
  Frame& frame, Reporter* reporter = nullptr, StageTimes* stages = nullptr);

/// Runs one of Pipeline::Runs over the tiles that are not done. BeginPipeline must precede the
/// first run.
FrameCounters RunPipelinePart(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  std::size_t run, Frame& frame, Reporter& reporter, TilesDone& done);

/// Adds `counted` to `total`, except seconds.
void AddCounters(const FrameCounters& counted, FrameCounters& total);
/// Adds the counters of samples that are not pixels' centres: rays and PrecisionCheck only.
void AddSamples(const FrameCounters& counted, FrameCounters& total);
} // namespace pixelexact
