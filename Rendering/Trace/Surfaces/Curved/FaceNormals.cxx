// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include "Core/Element/Kernels.h"
#include "Core/Faces/FacePlane.h"
#include "Trace/Surfaces/Arguments.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
void FaceNormals(
  const Mesh& mesh, const CurvedPart& part, std::span<const Vec3> xi, std::span<Vec3> normals)
{
  const auto count = static_cast<int>(xi.size());
  const auto stride = static_cast<std::size_t>(PaddedCount(count));
  std::vector<double> lanes(15 * stride);
  const auto lane = [&](std::size_t k) { return lanes.data() + k * stride; };
  for (std::size_t i = 0; i < stride; ++i)
  {
    const Vec3& at = xi[std::min(i, xi.size() - 1)];
    for (std::size_t d = 0; d < 3; ++d)
    {
      lane(d)[i] = at[static_cast<int>(d)];
    }
  }
  double* const value[3] = { lane(3), lane(4), lane(5) };
  double* slope[9];
  for (std::size_t k = 0; k < 9; ++k)
  {
    slope[k] = lane(6 + k);
  }
  const Space& space = mesh.map.SpaceOf(part.element);
  KernelsFor(space).gradient(space, mesh.map.Coefficients(part.element), 3,
    { { lane(0), lane(1), lane(2) }, count }, value, slope);
  // Distances grow inwards.
  const Vec3 n =
    -FacePlanesOf(mesh.ShapeOf(part.element))[static_cast<std::size_t>(part.face)].gradient;
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    // The cofactors of J take normals in xi to normals in space.
    Vec3 normal(0.0);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::size_t p = 3 * ((c + 1) % 3);
      const std::size_t q = 3 * ((c + 2) % 3);
      for (std::size_t d = 0; d < 3; ++d)
      {
        const std::size_t e = (d + 1) % 3;
        const std::size_t f = (d + 2) % 3;
        normal[static_cast<int>(c)] += n[static_cast<int>(d)] *
          (slope[p + e][i] * slope[q + f][i] - slope[p + f][i] * slope[q + e][i]);
      }
    }
    normals[i] = UnitOrZero(normal);
  }
}
} // namespace pixelexact
