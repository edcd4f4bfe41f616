// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/DeviationSteps.h"

#include "Core/Bernstein/Krawczyk.h"
#include "Core/Math/Rounding.h"
#include "Core/Tree/Regularity.h"

#include <cmath>

namespace pixelexact
{
namespace
{
/// Below 1 by far more than the rounding here, and than what Phi's derivatives change by over
/// 1e-12, by which a root that counts as in a box's reach may lie beyond it.
constexpr double kRegularSlope = 1.0 - 1e-4;

/// A bound, over a hexahedron's box and its reach, of the sums over j of |d T_d / d xi_j|: of the
/// derivatives' coefficients, which are differences of neighbours times the degree.
double SlopeOf(
  const std::array<int, 3>& degree, const DeviationSteps& steps, const NodeFrame& frame)
{
  double largest = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      const auto axis = static_cast<int>(j);
      sum += (LargestStep(steps[d][j]) + 2.0 * frame.slack[d]) * degree[j] /
        (frame.box.upper[axis] - frame.box.lower[axis]);
    }
    largest = std::max(largest, sum);
  }
  return largest * GrowthInReach(degree) * (1.0 + Gamma(16));
}

/// Whether M J is strictly diagonally dominant over a hexahedron's box and its reach, where J is
/// Phi's Jacobian and M near its inverse in the middle of what it is over the box: A J is I and the
/// derivatives of D, which lie within radii R of their middles; with B about the inverse of I and
/// these, B A J is B (I + middles) up to |B| R.
bool IsDominant(
  const std::array<int, 3>& degree, const DeviationSteps& steps, const NodeFrame& frame)
{
  const double growth = GrowthInReach(degree) * (1.0 + Gamma(16));
  SmallMatrix middle{};
  SmallMatrix radius{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const auto axis = static_cast<int>(j);
      const double factor = degree[j] / (frame.box.upper[axis] - frame.box.lower[axis]);
      const auto& [least, most] = steps[d][j];
      middle[d][j] = 0.5 * (least + most) * factor + (d == j ? 1.0 : 0.0);
      radius[d][j] = (0.5 * (most - least) + 2.0 * frame.slack[d]) * factor * growth;
    }
  }
  const auto inverse = Inverse(3, middle);
  // Products stay below what would need more than the room that there is for rounding.
  constexpr double kLargest = 1e6;
  bool dominant = inverse.has_value();
  for (std::size_t i = 0; dominant && i < 3; ++i)
  {
    const auto& B = (*inverse)[i];
    double apart = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      double product = i == j ? -1.0 : 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        product += B[k] * middle[k][j];
        apart += std::fabs(B[k]) * radius[k][j];
        dominant = dominant && std::fabs(B[k]) * (1.0 + std::fabs(middle[k][j])) < kLargest;
      }
      apart += std::fabs(product);
    }
    dominant = dominant && apart < kRegularSlope;
  }
  return dominant;
}
} // namespace

bool IsInjective(const std::array<int, 3>& degree, const DeviationSteps& steps,
  const NodeFrame& frame, bool products)
{
  // Products of what bends much are never dominant.
  constexpr double kHopeless = 8.0;
  const double slope = SlopeOf(degree, steps, frame);
  return slope < kRegularSlope ||
    (products && slope < kHopeless && IsDominant(degree, steps, frame));
}
} // namespace pixelexact
