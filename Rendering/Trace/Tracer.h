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
/// Traces a frame. Casts the rays that the pipeline and `extra` need, locates and evaluates the
/// hits, and runs the pipeline tile by tile, while a tile's samples are in cache. With translucent
/// layers, the pipeline runs after all tiles. The frame keeps the corners of `extra`. Parallel over
/// tiles; the frame is the same, bit for bit, for any number of threads. Throws Error for a scene
/// that cannot be traced (RequireTraceable). Tiles that `progress` aborts are Nothing. `stages`, if
/// not null, gets the time of each stage added, summed over threads for tiles; the frame then takes
/// some percent longer. `spare`: a frame to discard; the new frame reuses its memory.
Frame Trace(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  const SampleNeeds& extra = {}, const Progress& progress = {}, StageTimes* stages = nullptr,
  Frame spare = {});

/// A frame with one sample for each block of `stride` x `stride` pixels, `stride` at least 1. The
/// sample is that of the block's middle pixel (of an even stride, the one up and right of the
/// middle), bit for bit as Trace finds it, and is copied to all pixels of the block. The middle of
/// a block at the right or upper edge may lie outside the image. Counters: verdicts count pixels,
/// rays count samples. Throws Error as Trace; aborted tiles are Nothing.
[[nodiscard]] Frame TraceStrided(const Scene& scene, const Camera& camera, Buffer centres,
  int stride, const Progress& progress = {});

/// Traces the frame's corners with the buffers `wanted`, unless the frame holds them, and keeps
/// them. Modules read corners that a frame holds, and no others are traced. Returns false if
/// `progress` aborted it; then the frame has no corners.
[[nodiscard]] bool KeepCorners(const Scene& scene, const Camera& camera, Buffer wanted,
  Frame& frame, const Progress& progress = {});

/// Paints a frame with other colours. Its centres must have the buffers that the pipeline needs.
/// Traces only samples that the modules request.
void Repaint(const Scene& scene, const Camera& camera, const Pipeline& pipeline, Frame& frame);
/// The same without a scene: throws Error if a module requests samples.
void Repaint(const Pipeline& pipeline, Frame& frame);
} // namespace pixelexact
