// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeRefiner.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Searches iso-values inside pixels whose edges are Out. A pixel's square is quartered until all
/// that it may meet stays on one side, or until two samples bracket an iso-value.
class PixelInteriors
{
public:
  /// `states`: verdicts of all pixels; only those that are Out are searched. All arguments must
  /// outlive the object.
  PixelInteriors(LayerSight& sight, const EdgeClassifier& classifier, const ContourMethod& method,
    std::span<ContourVerdict> states, ContourCounters& counted);

  /// A pixel's corners: lower left, lower right, upper right, upper left.
  using Corners = std::array<EdgeEnd, 4>;
  void Add(std::size_t pixel, const Corners& corners);
  /// Classifies the added pixels.
  void Refine();

private:
  struct Square
  {
    std::size_t pixel;
    Corners corners;
  };

  /// Nothing that the square may meet takes an iso-value, and all of it is on one side.
  [[nodiscard]] bool IsOut(const Square& square) const;
  void Settle(const Square& square, int level);
  /// Makes the pixel In if the surface is continuous between samples on both sides of an iso-value.
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
