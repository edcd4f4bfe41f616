// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"
#include "Core/Math/Interval.h"

#include <vector>

namespace pixelexact
{
/// The strictly monotone functions that an expression F applies last: F = h(G), as in
/// |v| = sqrt(v . v). F = c where G = h^-1(c). G needs fewer operations than F, and has no pole
/// where the gradient of a root has one.
class OuterFunctions
{
public:
  /// The functions that `node` ends with: roots and logarithms of nodes that are not negative by
  /// their operations (sums of squares), exponentials, and sums, products and quotients with
  /// constants.
  OuterFunctions(const Graph& graph, int node);

  /// The node of G.
  [[nodiscard]] int Inner() const { return Node; }
  /// Returns h^-1 of a value. Outside of the range of h it is infinite, on the value's side.
  [[nodiscard]] double Invert(double value) const;
  /// Bounds the rounding of h and Invert together, where G has these values: Invert of a computed
  /// value of F differs from the computed value of G by at most this, and for a value c that F
  /// takes, Invert(c) from h^-1(c).
  [[nodiscard]] double ErrorOver(const Interval& inner) const;

private:
  /// y = Sqrt(x), Exp(x), Log(x), x + constant, x constant or x / constant.
  struct Step
  {
    Operation operation;
    double constant;
  };
  std::vector<Step> Steps; ///< the one that F applies last comes first
  int Node;
};
} // namespace pixelexact
