// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include "Core/Element/LaneBuffer.h"
#include "Trace/Surfaces/Curved/FaceModes.h"
#include "Trace/Surfaces/Curved/FaceNormalKernels.h"

#include <vector>

namespace pixelexact
{
void FaceNormals(const FaceMap& map, std::span<const Vec3> xi, std::span<Vec3> normals)
{
  const auto count = static_cast<int>(xi.size());
  const auto stride = static_cast<std::size_t>(PaddedCount(count));
  std::vector<double> lanes(13 * stride);
  const auto lane = [&](std::size_t k) { return lanes.data() + k * stride; };
  const LaneBuffer points(xi);
  double* const value[3] = { lane(0), lane(1), lane(2) };
  double* slope[7];
  for (std::size_t k = 0; k < 7; ++k)
  {
    slope[k] = lane(3 + k);
  }
  map.Evaluate(points.View(), value, slope);
  double* const normal[3] = { lane(10), lane(11), lane(12) };
  GetFaceNormalKernels().make(map.OutwardSign(), slope, count, normal);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    normals[i] = { normal[0][i], normal[1][i], normal[2][i] };
  }
}
} // namespace pixelexact
