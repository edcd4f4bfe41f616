// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/CutFunction.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace pixelexact
{
double QuadricForm::ValueAround(const Vec3& z) const
{
  return q[0] * z.x * z.x + q[1] * z.y * z.y + q[2] * z.z * z.z + q[3] * z.x * z.y +
    q[4] * z.y * z.z + q[5] * z.x * z.z + glm::dot(g, z) + c;
}

Vec3 QuadricForm::GradientAround(const Vec3& z) const
{
  return g +
    Vec3(2.0 * q[0] * z.x + q[3] * z.y + q[5] * z.z, 2.0 * q[1] * z.y + q[3] * z.x + q[4] * z.z,
      2.0 * q[2] * z.z + q[4] * z.y + q[5] * z.x);
}

void CutFunction::Values(std::span<const Vec3> x, std::span<double> values) const
{
  std::ranges::transform(x, values.begin(), [this](const Vec3& at) { return Value(at); });
}

void CutFunction::Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const
{
  std::ranges::transform(x, gradients.begin(), [this](const Vec3& at) { return Gradient(at); });
}
} // namespace pixelexact
