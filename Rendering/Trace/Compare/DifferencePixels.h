// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Compare/FieldDifference.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pixelexact
{
/// Collects pixels and evaluates both fields at many of them together.
class DifferencePixels
{
public:
  /// Both arguments must outlive the object. Reads positions, elements and xi of the result's
  /// frame; writes values, bounds, sides and verdicts.
  DifferencePixels(const DifferenceScene& scene, FieldDifference& result);

  void Add(std::size_t pixel);
  [[nodiscard]] bool IsFull() const;
  /// Evaluates all added pixels.
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
