// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeRefiner.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Looks for values inside of pixels on whose edges there are none: the pixel's square is quartered
/// until all that it may meet stays on one side, or a value is between two samples.
class PixelInteriors
{
public:
  /// `states`: of all pixels; only those that are out are asked. All must outlive it.
  PixelInteriors(LayerSight& sight, const EdgeClassifier& classifier, const ContourMethod& method,
    std::span<ContourVerdict> states, ContourCounters& counted);

  /// A pixel's corners: lower left, lower right, upper right, upper left.
  using Corners = std::array<EdgeEnd, 4>;
  void Add(std::size_t pixel, const Corners& corners);
  /// Settles what has been added.
  void Refine();

private:
  struct Square
  {
    std::size_t pixel;
    Corners corners;
  };

  /// Whether nothing that it may meet takes a value, and all is on one side.
  [[nodiscard]] bool IsOut(const Square& square) const;
  void Settle(const Square& square, int level);
  /// Samples that show the layer on either side of a value: whether it is between them.
  void Compare(const Square& square, std::span<const EdgeEnd> samples);

  LayerSight& Sight;
  const EdgeClassifier& Classifier;
  ContourMethod Method;
  std::span<ContourVerdict> States;
  ContourCounters& Counted;
  EdgeRefiner Lines;        ///< from sample to sample
  std::vector<int> Squares; ///< open, of each pixel
  std::vector<Square> Open;
};
} // namespace pixelexact
