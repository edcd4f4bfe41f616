// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Faces/FacePlane.h"
#include "Trace/Surfaces/Curved/FaceNormalKernels.h"

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
  const LaneBuffer points(xi);
  double* const value[3] = { lane(0), lane(1), lane(2) };
  double* slope[9];
  for (std::size_t k = 0; k < 9; ++k)
  {
    slope[k] = lane(3 + k);
  }
  const Space& space = mesh.map.SpaceOf(part.element);
  KernelsFor(space).gradient(
    space, mesh.map.Coefficients(part.element), 3, points.View(), value, slope);
  // Distances grow inwards.
  const Vec3 outwards =
    -FacePlanesOf(mesh.ShapeOf(part.element))[static_cast<std::size_t>(part.face)].gradient;
  double* const normal[3] = { lane(12), lane(13), lane(14) };
  GetFaceNormalKernels().make(outwards, slope, count, normal);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    normals[i] = { normal[0][i], normal[1][i], normal[2][i] };
  }
}
} // namespace pixelexact
