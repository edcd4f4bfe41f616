// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/Regularity.h"

#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Bernstein/Krawczyk.h"
#include "Core/Element/Kernels.h"
#include "Core/Math/Mat.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace pixelexact
{
bool CollapsesAt(Shape shape, int direction)
{
  return shape != Shape::Hexahedron &&
    (direction == 2 || (shape == Shape::Tetrahedron && direction == 1));
}

double ReachOf(const std::array<int, 3>& degree)
{
  return 1.0 / (4.0 * std::max(1, degree[0] + degree[1] + degree[2]));
}

double GrowthInReach(const std::array<int, 3>& degree)
{
  return std::pow(1.0 + 2.0 * ReachOf(degree), degree[0] + degree[1] + degree[2]);
}

bool IsRegular(const std::array<int, 3>& degree, const BoxCoefficients& slopes)
{
  SmallMatrix middle{};
  std::array<double, 9> magnitude{};
  for (std::size_t f = 0; f < 9; ++f)
  {
    const Interval hull = slopes.HullOf(f);
    if (!hull.IsFinite())
    {
      return false;
    }
    middle[f / 3][f % 3] = hull.Middle();
    magnitude[f] = hull.Magnitude();
  }
  const auto inverse = Inverse(3, middle);
  if (!inverse)
  {
    return false;
  }
  const double growth = GrowthInReach(degree);
  // Takes hulls of the products, not products with the hulls: whether a box is regular must not
  // depend on how the element is stretched.
  BoxCoefficients row;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& M = (*inverse)[i];
    double diagonal = 0.0;
    double others = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      row = {};
      row.values.resize(slopes.Of(0).size());
      double slack = 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto slope = slopes.Of(3 * c + j);
        for (std::size_t at = 0; at < slope.size(); ++at)
        {
          row.values[at] += M[c] * slope[at];
        }
        slack += std::fabs(M[c]) * (slopes.error[3 * c + j] + Gamma(4) * magnitude[3 * c + j]);
      }
      row.error = { slack * (1.0 + Gamma(16)) };
      const Interval hull = row.HullOf(0);
      const double around = hull.Middle();
      const double radius = hull.RadiusAround(around) * growth;
      if (i == j)
      {
        diagonal = around - radius;
      }
      else
      {
        others += std::fabs(around) + radius;
      }
    }
    // Far more than the rounding of these sums, and than what the slopes change by over the
    // tolerance of 1e-12 by which a root that counts as in the box may lie beyond it, also on the
    // scale of a pyramid's apex. A NaN is not above.
    if (!(diagonal > others + 1e-4))
    {
      return false;
    }
  }
  return true;
}

bool IsFlatOver(const Space& space, const double* modes, const EtaBox& box)
{
  constexpr double kThin = 1e-14;
  constexpr std::size_t kPoints = 9;
  constexpr std::size_t kLanes = 16;
  // Multiples of these, less whole numbers, spread evenly, and on no plane of symmetry.
  constexpr std::array<double, 3> kSteps{ 0.8191725, 0.6710436, 0.5497005 };
  alignas(64) std::array<std::array<double, kLanes>, 15> lanes;
  std::array<double*, 15> at{};
  for (std::size_t k = 0; k < at.size(); ++k)
  {
    at[k] = lanes[k].data();
  }
  for (std::size_t i = 0; i < kLanes; ++i)
  {
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      const double multiple =
        static_cast<double>(std::min(i, kPoints - 1) + 1) * kSteps[static_cast<std::size_t>(d)];
      eta[d] = glm::mix(box.lower[d], box.upper[d], multiple - std::floor(multiple));
    }
    const Vec3 xi = TensorToReference(space.shape, eta);
    for (int d = 0; d < 3; ++d)
    {
      lanes[static_cast<std::size_t>(d)][i] = xi[d];
    }
  }
  KernelsFor(space).gradient(space, modes, 3,
    { { at[0], at[1], at[2] }, static_cast<int>(kPoints) }, at.data() + 3, at.data() + 6);
  for (std::size_t i = 0; i < kPoints; ++i)
  {
    Mat3 jacobian;
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        jacobian[static_cast<int>(j)][static_cast<int>(c)] = lanes[6 + 3 * c + j][i];
      }
    }
    double area = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      area = std::max(area, glm::length(glm::cross(jacobian[j], jacobian[(j + 1) % 3])));
    }
    if (!(std::fabs(glm::determinant(jacobian)) <= kThin * area))
    {
      return false;
    }
  }
  return true;
}
} // namespace pixelexact
