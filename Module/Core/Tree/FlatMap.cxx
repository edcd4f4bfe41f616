// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/FlatMap.h"

#include "Core/Element/Kernels.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
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
