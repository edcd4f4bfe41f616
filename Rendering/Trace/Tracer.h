// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/StageClock.h"
#include "Trace/Camera.h"
#include "Trace/Frame.h"
#include "Trace/Pipeline.h"
#include "Trace/Reporter.h"
#include "Trace/Scene.h"

namespace pixelexact
{
/// Casts the rays that the pipeline (and `extra`, whose corners the frame keeps) needs, locates and
/// evaluates the hits, and runs the pipeline tile by tile, while a tile's samples are in cache;
/// with translucent layers when all are known. Parallel over tiles; the frame is the same, bit for
/// bit, for any number of threads. Throws Error for a scene that cannot be traced
/// (RequireTraceable); an aborted frame comes back with the tiles not done as Nothing. `stages`,
/// where not null, gets the time of each stage added, that of the tiles summed over threads; the
/// frame then takes some percent longer. `spare` is a frame that is not needed any more: the new
/// one is made in its memory, as far as that goes, and nothing of it is left.
Frame Trace(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  const SampleNeeds& extra = {}, const Progress& progress = {}, StageTimes* stages = nullptr,
  Frame spare = {});

/// A frame with one sample for each block of `stride` x `stride` pixels, `stride` at least 1: that
/// of the block's middle pixel (of an even stride the one up and right of the middle), bit for bit
/// as Trace finds it, in all pixels of the block. The middle of a block that the right or upper
/// edge cuts off may lie outside the image. Counters: verdicts count pixels, rays samples. Throws
/// Error as Trace; aborted tiles are Nothing.
[[nodiscard]] Frame TraceStrided(const Scene& scene, const Camera& camera, Buffer centres,
  int stride, const Progress& progress = {});

/// Traces the frame's corners, where it does not hold them with these buffers, and keeps them:
/// where a frame has corners, modules get these and no others are traced. False where `progress`
/// aborted it: then it has none.
[[nodiscard]] bool KeepCorners(const Scene& scene, const Camera& camera, Buffer wanted,
  Frame& frame, const Progress& progress = {});

/// Other colours for a frame that has the buffers that the pipeline needs of centres. Traces
/// nothing but what its modules ask for.
void Repaint(const Scene& scene, const Camera& camera, const Pipeline& pipeline, Frame& frame);
/// The same without the scene: throws Error where a module asks for samples.
void Repaint(const Pipeline& pipeline, Frame& frame);
} // namespace pixelexact
