// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/FrameTiles.h"

#include <cstddef>
#include <span>

// Runs of a pipeline's colours and modules over the tiles of a frame.
namespace pixelexact
{
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
} // namespace pixelexact
