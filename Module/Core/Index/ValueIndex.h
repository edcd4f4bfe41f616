// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Ranges.h"

#include <vector>

namespace pixelexact
{
/// Which elements may take a value: the certified range of a quantity over each element of a mesh,
/// all made at once, in parallel. For iso-surfaces and contours, which look at no other elements.
/// Safe to use from several threads.
class ValueIndex
{
public:
  /// `boxes`: the largest number visited per element; more make ranges tighter. Throws Unsupported
  /// as RequireAnswer. The arrays are not needed afterwards.
  explicit ValueIndex(const Mesh& mesh, const RangeQuestion& question, int boxes = kFewBoxes);

  /// Finds the elements whose range meets these values, in ascending order. An element that takes
  /// one of them is never left out, nor is an element without a known range (a coefficient is not
  /// finite). None for a NaN.
  void Find(const Interval& values, std::vector<int>& elements) const;

  [[nodiscard]] const Interval& RangeOf(int element) const
  {
    return Ranges[static_cast<std::size_t>(element)];
  }
  /// Holds all values; empty for an empty mesh.
  [[nodiscard]] const Interval& Range() const { return Whole; }
  [[nodiscard]] std::size_t MemoryUsage() const { return Ranges.capacity() * sizeof(Interval); }

private:
  static constexpr int kFewBoxes = 16;

  std::vector<Interval> Ranges;
  Interval Whole;
};
} // namespace pixelexact
