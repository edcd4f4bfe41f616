// SPDX-License-Identifier: BSD-3-Clause
#ifndef GradientSpread_h
#define GradientSpread_h

#include "Core/Element/Kernels.h"

#include <vector>

namespace pixelexact
{
/// Between which values the gradients of a space's modes are at sample points. A map's Jacobian
/// there is at most so far from a matrix in the middle, which often decides the sign of its
/// determinant at all of them without looking at any.
class GradientSpread
{
public:
  GradientSpread(const Space& space, const LanePoints& samples);

  /// 1 or -1 where det J has this sign at every sample, its size above `vanishing` times the
  /// product of the lengths of J's columns; 0: not decided. `coefficients`: three components.
  [[nodiscard]] int SignOfJacobian(const double* coefficients, double vanishing) const;

private:
  /// Of a derivative by one xi.
  struct Range
  {
    double middle;
    double reach;
  };
  std::vector<Range> Ranges; ///< three per mode
};
} // namespace pixelexact
#endif
