// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Pipeline.h"

#include <atomic>
#include <cstdint>
#include <span>

namespace pixelexact
{
/// Gives pixels whose centre and corners differ in colour the mean of several samples. Changes only
/// the frame's image; its buffers stay those of the pixels' centres. Without colours it does
/// nothing.
class Antialiasing final : public FrameModule
{
public:
  /// Largest difference of a colour channel, of 255, within one colour.
  static constexpr int kAlike = 8;

  /// `samples`: per refined pixel, at least 1.
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
