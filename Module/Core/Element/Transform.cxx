// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Transform.h"

#include <glm/matrix.hpp>

namespace pixelexact
{
std::vector<Mat3> Jacobians(const Mesh& mesh, int element, const LanePoints& xi)
{
  const Space& space = mesh.map.SpaceOf(element);
  const auto stride = static_cast<std::size_t>(PaddedCount(xi.count));
  std::vector<double> storage(12 * stride);
  double* arrays[12];
  for (std::size_t k = 0; k < 12; ++k)
  {
    arrays[k] = &storage[k * stride];
  }
  KernelsFor(space).gradient(space, mesh.map.Coefficients(element), 3, xi, arrays, arrays + 3);
  std::vector<Mat3> jacobians(xi.count);
  for (int i = 0; i < xi.count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int d = 0; d < 3; ++d)
      {
        jacobians[i][d][c] = arrays[3 + 3 * c + d][i];
      }
    }
  }
  return jacobians;
}

void ToWorldGradient(
  const Mesh& mesh, int element, const LanePoints& xi, int components, double* const* gradient)
{
  const auto jacobians = Jacobians(mesh, element, xi);
  const double inverseSize = 1.0 / mesh.size[element];
  for (int i = 0; i < xi.count; ++i)
  {
    const Mat3 transform = glm::transpose(glm::inverse(jacobians[i]));
    for (int c = 0; c < components; ++c)
    {
      double* const* g = gradient + 3 * c;
      const Vec3 world = transform * Vec3(g[0][i], g[1][i], g[2][i]) * inverseSize;
      for (int d = 0; d < 3; ++d)
      {
        g[d][i] = world[d];
      }
    }
  }
}
} // namespace pixelexact
