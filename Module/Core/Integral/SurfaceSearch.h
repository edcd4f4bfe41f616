// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/GraphIntegral.h"
#include "Core/Integral/Integrate.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pixelexact
{
/// A value that is proven to be attained, and its place in an element's eta, up to rounding. No
/// value is known where the interval is empty.
struct Attained
{
  double value = std::numeric_limits<double>::quiet_NaN();
  Vec3 eta{ 0.0 };
};

/// One end of the range of values: all numbers are multiplied by the sign, so that the least one is
/// searched.
struct RangeEnd
{
  double sign = 1.0;
  Attained least; ///< proven: a value not above it is attained
  int part = -1;

  [[nodiscard]] bool IsKnown() const { return !std::isnan(least.value); }
  /// Returns whether the value is beyond the known one, and keeps it then.
  bool Take(const Attained& other, int of);
};

/// The ends of all parts that are known at the beginning of a round.
struct KnownRange
{
  RangeEnd lower{ 1.0, {}, -1 };
  RangeEnd upper{ -1.0, {}, -1 };

  /// The gap that is requested for this range.
  [[nodiscard]] double Gap(double tolerance) const;
};

struct ExtremeBox
{
  PieceBox box;
  Interval outer; ///< holds the values on the surface in the box
  int direction = -1;
};

/// The search for the extremes of a scalar on a surface in one element, or on one of its faces.
class SurfaceSearch
{
public:
  /// `component`: of the field, or FieldFunction::kNorm. `face`: -1 for the cut.
  SurfaceSearch(const IntegralQuestion& question, int component, int element, int face);

  [[nodiscard]] bool IsFinite() const { return Finite; }
  [[nodiscard]] bool IsEmpty() const { return Boxes.empty(); }
  [[nodiscard]] std::int64_t Looked() const { return Count; }
  [[nodiscard]] const RangeEnd& Lower() const { return Low; }
  [[nodiscard]] const RangeEnd& Upper() const { return High; }
  /// Holds all values; lower > upper where there is none.
  [[nodiscard]] Interval Outer() const;

  /// Subdivides boxes that exceed the known range by more than the gap, the farthest first. Returns
  /// whether none is left.
  bool Refine(const KnownRange& known, double tolerance, int boxes);

  int Element;

private:
  void Look(ElementFunctions& functions, const PieceBox& box);
  /// The range of the scalar over all of a box.
  Interval RangeIn(ElementFunctions& functions, const PieceBox& box) const;
  /// The scalar's own value from that of the model, which is a magnitude's square.
  [[nodiscard]] Interval FromModel(const Interval& value) const;
  void LookAt(const SurfaceValues& surface, const PieceBox& box);
  /// Takes values at places of the surface that count.
  void TakeValues(const SurfaceValues& surface, const ChebyshevModel& model);

  IntegralQuestion question_;
  int Component;
  int Face;
  double Tolerance = 0.0; ///< of the cut's polynomial
  bool Finite = true;
  std::vector<ExtremeBox> Boxes;
  std::int64_t Count = 0;
  RangeEnd Low{ 1.0, {}, -1 };
  RangeEnd High{ -1.0, {}, -1 };
};
} // namespace pixelexact
