// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/SeedList.h"

namespace pixelexact
{
/// Limits of the search for seeds.
struct SeedAccuracy
{
  /// The largest distance, in xi, between a root of the polynomials and the point to which Newton's
  /// iteration leads: the same root, if the polynomials are the contour's own.
  double reach = 0.0;
  int boxes = 0; ///< parts that may be looked at
};

/// Boxes that the root finder takes for a part that is not split any more.
inline constexpr int kLastBoxes = 1000;
/// The smallest box of the root finder, as a fraction of the element's. In a smaller one the errors
/// of noisy coefficients, some 1e-12, would leave no root provable.
inline constexpr double kSmallestBox = 0x1p-32;

/// Finds where contours turn along a direction of eta: are normal to it.
class TurnSearch
{
public:
  TurnSearch(CurveEvaluator& evaluator, Shape shape, const Vec3& along,
    const SeedAccuracy& accuracy, SeedList& list)
    : Evaluator(evaluator)
    , shape_(shape)
    , Along(along)
    , Accuracy(accuracy)
    , List(list)
    , Left(accuracy.boxes)
  {
  }

  /// All turns in a part are listed, or the list is not complete.
  void Search(CurvePart part) { Visit(std::move(part), 0); }

private:
  void Visit(CurvePart part, int depth);
  [[nodiscard]] bool HasNone(const CurvePart& part) const;
  bool Ask(const CurvePart& part, bool last);
  [[nodiscard]] BoxPolynomial TurnOver(const CurvePart& part) const;

  CurveEvaluator& Evaluator;
  Shape shape_;
  Vec3 Along;
  SeedAccuracy Accuracy;
  SeedList& List;
  int Left;
};
} // namespace pixelexact
