// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/ChebyshevModel.h"
#include "Core/Expression/Graph.h"
#include "Core/Expression/IntervalOperations.h"

#include <span>

namespace pixelexact
{
/// A scalar on a parametrised piece of a surface: all of its values are in the model and in the
/// range. The model's error falls with a high power of the piece's size where the scalar is smooth;
/// the range is what is left where it is not. Where the scalar may be undefined (NaN) somewhere,
/// the model's error is infinite.
struct ModelValue
{
  ChebyshevModel model;
  KnownInterval known;
  /// Whether the scalar may jump on the piece: steps, comparisons, and selections by them.
  bool mayJump = false;

  ModelValue() = default;
  /// A number, exactly.
  // NOLINTNEXTLINE(google-explicit-constructor): a number is a constant.
  ModelValue(double value);
  /// A scalar of which the range alone is known.
  explicit ModelValue(const KnownInterval& interval);
  /// A scalar of which the model alone is known.
  explicit ModelValue(const ChebyshevModel& itsModel);
  /// `itsModel` and `interval` are both proven; a bounded model of `defined` arguments proves that
  /// the scalar is no NaN.
  ModelValue(const ChebyshevModel& itsModel, const KnownInterval& interval, bool areDefined);

  /// A scalar without any bound.
  static ModelValue Unknown() { return ModelValue(KnownInterval{ Interval::Everything(), true }); }
};

ModelValue operator+(const ModelValue& f, const ModelValue& g);
ModelValue operator-(const ModelValue& f, const ModelValue& g);
ModelValue operator*(const ModelValue& f, const ModelValue& g);
ModelValue Square(const ModelValue& f);
ModelValue Reciprocal(const ModelValue& f);
/// The Euclidean norm.
ModelValue NormOf(std::span<const ModelValue> values);

/// Computes a node that has arguments, which are places in `values`. Smooth functions are replaced
/// by their interpolation at Chebyshev's points of the argument's range, whose remainder is bounded
/// by the next derivative (N. Brisebarre, M. Joldes, ISSAC 2010). Eigenvalues are proven by the
/// characteristic polynomial where they are simple. Steps, kinks and eigenvectors have their range
/// alone unless the piece is on one side of them.
[[nodiscard]] ModelValue ApplyToModels(const Graph::Node& node, std::span<const ModelValue> values);
} // namespace pixelexact
