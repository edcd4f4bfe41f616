// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/AffineForm.h"
#include "Core/Expression/Graph.h"
#include "Core/Expression/IntervalOperations.h"

#include <span>

namespace pixelexact
{
/// A scalar over a box: all of its values are in the affine form and in the range, or are NaN. The
/// form is what keeps enclosures tight on small boxes: its remainder falls with the square of the
/// box's width. The range is what sums of squares, absolute values and the like are sharp in.
struct BoxValue
{
  AffineForm form;
  KnownInterval known;
  /// Bounds the distance between the value and the double that the program computes, at any point
  /// of the box.
  double error = 0.0;
  /// Whether the scalar may jump in the box: steps, comparisons, and selections by them.
  bool mayJump = false;

  BoxValue() = default;
  /// A number, exactly.
  // NOLINTNEXTLINE(google-explicit-constructor): a number is a constant.
  BoxValue(double value)
    : form(value)
    , known{ Interval(value), false }
  {
  }
  /// A scalar of which the range alone is known.
  explicit BoxValue(const KnownInterval& interval);
  /// `range` and the form's own are both proven.
  BoxValue(const AffineForm& itsForm, const KnownInterval& interval);

  /// A scalar without any bound.
  static BoxValue Unknown() { return BoxValue(KnownInterval{ Interval::Everything(), true }); }

  /// Holds all values; everything where one may be NaN.
  [[nodiscard]] Interval Range() const
  {
    return known.mayBeNaN ? Interval::Everything() : known.value;
  }
};

BoxValue operator+(const BoxValue& f, const BoxValue& g);
BoxValue operator-(const BoxValue& f, const BoxValue& g);
BoxValue operator*(const BoxValue& f, const BoxValue& g);
BoxValue Square(const BoxValue& f);
BoxValue Reciprocal(const BoxValue& f);
BoxValue Sqrt(const BoxValue& f);
/// The Euclidean norm.
BoxValue NormOf(std::span<const BoxValue> values);

/// Computes a node that has arguments, which are places in `values`. Functions are linearised about
/// the middle of the argument's range, with the range of their derivative (the mean value form);
/// where that is not bounded, and for eigenvalues, the form is the range alone.
[[nodiscard]] BoxValue ApplyToBoxes(const Graph::Node& node, std::span<const BoxValue> values);
} // namespace pixelexact
