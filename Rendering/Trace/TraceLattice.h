// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tile.h"

#include <atomic>
#include <thread>

namespace pixelexact
{
/// Throws Error for a scene without locator, field or surface, a component out of range, or
/// enclosures of values in single precision.
void RequireTraceable(const Scene& scene, const SampleNeeds& needs);

/// Progress and abort, shared by the tiles of a frame.
class Reporter
{
public:
  Reporter(const Progress& progress, int total);

  [[nodiscard]] bool IsAborted() const { return Aborted; }
  void TileDone();

private:
  const Progress& TheProgress;
  int Total;
  std::thread::id Caller;
  std::atomic<int> Done{ 0 };
  std::atomic<bool> Aborted{ false };
};

/// Tiles of a lattice over width x height samples.
int TilesOf(const SampleLattice& lattice, int width, int height);

/// Traces the samples of a lattice, in parallel over tiles; aborted tiles are left out. `stages`
/// may be null.
FrameCounters TraceLattice(const Scene& scene, const Camera& camera, const SampleLattice& lattice,
  SampleBuffers& buffers, Reporter& reporter, StageTimes* stages);

/// Adds what was counted; seconds are left alone.
void AddCounters(const FrameCounters& counted, FrameCounters& total);
} // namespace pixelexact
