// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Pipeline.h"

#include <atomic>
#include <cstdint>
#include <span>

namespace pixelexact
{
/// Pixels that are not of one colour get the mean of several samples: those whose centre and
/// corners differ. The frame's image alone changes; its buffers stay those of the pixels' centres.
/// Without colours it does nothing.
class Antialiasing final : public FrameModule
{
public:
  /// Steps of a colour channel, of 255, that are taken for one colour.
  static constexpr int kAlike = 8;

  /// `samples` in a pixel that is refined, from 1.
  explicit Antialiasing(int samples);

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;

  /// Pixels of the last frame that were refined.
  [[nodiscard]] std::int64_t Refined() const { return RefinedPixels; }

private:
  void Refine(TileVisit& tile, std::span<const std::array<int, 2>> pixels);

  std::vector<std::array<double, 2>> Offsets; ///< of the samples within a pixel
  std::atomic<std::int64_t> RefinedPixels{ 0 };
};
} // namespace pixelexact
