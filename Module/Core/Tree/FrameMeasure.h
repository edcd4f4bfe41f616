// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/Krawczyk.h"
#include "Core/Tree/DeviationSteps.h"
#include "Core/Tree/FrameKernels.h"
#include "Core/Tree/NodeFrame.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Compares Phi's coefficients over a box with the frame about its centre (its value, Jacobian's
/// inverse and hull are known). It is the main part of MakeFrame.
class FrameMeasure
{
public:
  FrameMeasure(
    const Space& space, const ElementBounds& bounds, const BoxCoefficients& phi, NodeFrame& frame);

  /// Sets deviation, slack, planes and `injective`. Returns the variation of the deviation along
  /// each direction of eta.
  std::array<double, 3> Measure();

  /// Replaces the planes of a box that bends too much for its centre's Jacobian by planes with the
  /// Jacobian in the middle of each end. Where a face is collapsed to an edge, boxes at the edge
  /// bend as much however small they are, and these planes meet in the edge.
  void TiltPlanes(std::span<const SmallMatrix, 6> jacobian);

private:
  [[nodiscard]] FrameTask Task(std::span<const double[3]> normal);
  /// For each row of the deviation, the differences of neighbouring coefficients in each direction
  /// of eta.
  [[nodiscard]] DeviationSteps Steps(const std::array<int, 3>& degree);
  /// Bounds the effect of rounding and uncertainty on the product of a row with Phi - origin.
  [[nodiscard]] double SlackOf(const double* row) const;
  void MakeGrid(const std::array<int, 3>& degree);

  double* Row(std::size_t k) { return &Values[k * Padded]; }
  void Fill(double* row) const;

  const Space& space_;
  const ElementBounds& Bounds;
  const BoxCoefficients& Phi;
  NodeFrame& Frame;
  std::size_t Size;
  std::size_t Padded;
  std::vector<double>& Values; ///< three rows each: grid, deviation, coefficients where padded
  std::array<const double*, 3> From{};
  std::array<double, 3> Around{}; ///< of Phi - origin, per coordinate
};
} // namespace pixelexact
