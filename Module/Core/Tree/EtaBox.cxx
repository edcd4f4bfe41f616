// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/EtaBox.h"

#include <glm/common.hpp>

#include <cmath>

namespace pixelexact
{
namespace
{
/// Whether the extent s_d that eta_d is relative to falls with xi_3.
bool IsTilted(Shape shape, int direction)
{
  return direction == 0
    ? shape != Shape::Hexahedron
    : direction == 1 && (shape == Shape::Tetrahedron || shape == Shape::Pyramid);
}

/// The outward normal in xi of the end eta_d = b of a box: of 1 + xi_d - (1 + b) s_d(xi).
Vec3 EndNormal(Shape shape, int direction, double end, double sign)
{
  Vec3 normal(0.0);
  normal[direction] = sign;
  const double tilt = sign * 0.5 * (1.0 + end);
  if (IsTilted(shape, direction))
  {
    normal.z = tilt;
    normal.y = shape == Shape::Tetrahedron && direction == 0 ? tilt : normal.y;
  }
  return normal;
}

/// s_d at a xi.
double ExtentAt(Shape shape, int direction, const Vec3& xi)
{
  if (shape == Shape::Tetrahedron && direction == 0)
  {
    return 0.5 * (-xi.y - xi.z);
  }
  return IsTilted(shape, direction) ? 0.5 * (1.0 - xi.z) : 1.0;
}
} // namespace

Box3 HullInXi(Shape shape, const EtaBox& box)
{
  Box3 hull{ Vec3(INFINITY), Vec3(-INFINITY) };
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Vec3 xi = TensorToReference(shape,
      { (corner & 1U) != 0U ? box.upper.x : box.lower.x,
        (corner & 2U) != 0U ? box.upper.y : box.lower.y,
        (corner & 4U) != 0U ? box.upper.z : box.lower.z });
    hull.lower = glm::min(hull.lower, xi);
    hull.upper = glm::max(hull.upper, xi);
  }
  return hull;
}

std::array<double[3], 6> EndNormals(Shape shape, const EtaBox& box)
{
  std::array<double[3], 6> normal{};
  for (int k = 0; k < 6; ++k)
  {
    const Vec3& end = k % 2 == 1 ? box.upper : box.lower;
    const Vec3 n = EndNormal(shape, k / 2, end[k / 2], k % 2 == 1 ? 1.0 : -1.0);
    for (int d = 0; d < 3; ++d)
    {
      normal[static_cast<std::size_t>(k)][d] = n[d];
    }
  }
  return normal;
}

double DepthOf(Shape shape, const EtaBox& box, int end, const Vec3& xi)
{
  const int direction = end / 2;
  const double sign = end % 2 == 1 ? 1.0 : -1.0;
  const double at = (end % 2 == 1 ? box.upper : box.lower)[direction];
  return -sign * (1.0 + xi[direction] - (1.0 + at) * ExtentAt(shape, direction, xi));
}

std::array<Vec3, 7> MiddlesOf(Shape shape, const EtaBox& box)
{
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  std::array<Vec3, 7> xi;
  xi.fill(TensorToReference(shape, middle));
  for (int k = 0; k < 6; ++k)
  {
    Vec3 eta = middle;
    eta[k / 2] = (k % 2 == 1 ? box.upper : box.lower)[k / 2];
    xi[static_cast<std::size_t>(k)] = TensorToReference(shape, eta);
  }
  return xi;
}
} // namespace pixelexact
