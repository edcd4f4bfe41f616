// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Compare/FieldDifference.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pixelexact
{
/// Pixels whose fields are to be evaluated, both at once and many together.
class DifferencePixels
{
public:
  /// Both must outlive it. Positions, elements and xi are those of the result's frame; values,
  /// bounds, sides and verdicts are written to it.
  DifferencePixels(const DifferenceScene& scene, FieldDifference& result);

  void Add(std::size_t pixel);
  [[nodiscard]] bool IsFull() const;
  /// All that were added.
  void Evaluate();

private:
  struct PointValues;
  void EvaluateKnown(PointValues& found) const;
  void Write(std::size_t k, const PointValues& first, const PointValues& second);

  const DifferenceScene& Of;
  FieldDifference& Result;
  std::size_t Components;
  std::vector<std::size_t> Places;
  std::vector<Vec3> Points;
  std::vector<std::int64_t> Elements;
  std::vector<Vec3> Xis;
};
} // namespace pixelexact
