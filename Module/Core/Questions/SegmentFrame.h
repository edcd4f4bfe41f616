// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Bernstein/PolynomialSystem.h"
#include "Core/Index/ElementIndex.h"

#include <array>

namespace pixelexact
{
/// A segment as an element sees it: start + t along in the element's units, t in [0,1], rounding
/// included.
class SegmentFrame
{
public:
  SegmentFrame(const InverseProblem& problem, const Segment& segment);

  /// Whether it has a direction: `along` is not zero, proven, and all is finite.
  [[nodiscard]] bool HasDirection() const { return Directed; }

  /// All t of [0,1] where the segment may lie in the node; empty where it misses it: by its hull,
  /// its frame and the planes at its ends.
  [[nodiscard]] Interval Clip(Shape shape, const NodeFrame& node) const;

  /// Two polynomials that vanish exactly where three ones y, over a box, lie on the line: for k the
  /// coordinate along which the segment is longest and each other one a,
  ///   (y_a - start_a) - (along_a / along_k) (y_k - start_k).
  /// All polynomials have the same degrees.
  [[nodiscard]] std::array<TensorPolynomial, 2> Eliminate(
    std::span<const BoxPolynomial, 3> y) const;
  /// t of the points with this coordinate Axis().
  [[nodiscard]] Interval ParameterOf(const Interval& y) const;
  [[nodiscard]] int Axis() const { return Longest; }

private:
  std::array<Interval, 3> Start;
  std::array<Interval, 3> Along;
  int Longest = 0;
  bool Directed = false;
};
} // namespace pixelexact
