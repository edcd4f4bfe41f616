// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FaceSampler.h"

#include "Core/Basis/LineFunctions.h"
#include "Core/Element/Kernels.h"
#include "Core/Math/Mat.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kMinOpenPoints = 4; ///< along each direction

std::vector<FacePoint> Grid(const std::vector<long double>& line, int corners)
{
  std::vector<FacePoint> points;
  for (const long double u : line)
  {
    for (const long double v : line)
    {
      const auto first = static_cast<double>((1.0L + u) / 2.0L);
      const auto second = static_cast<double>((1.0L + v) / 2.0L);
      points.push_back({ corners == 3 ? first * (1.0 - second) : first, second });
    }
  }
  return points;
}
} // namespace

void FaceSampler::Sample(
  int element, int face, std::span<const FacePoint> points, std::vector<FaceSample>& samples)
{
  const Space& space = mesh_.map.SpaceOf(element);
  const ReferenceFace& reference = ReferenceFaceOf(space.shape, face);
  const auto count = static_cast<int>(points.size());
  const auto stride = static_cast<std::size_t>(PaddedCount(count));
  Lanes.resize(15 * stride);
  double* arrays[15];
  for (std::size_t k = 0; k < 15; ++k)
  {
    arrays[k] = &Lanes[k * stride];
  }
  for (std::size_t i = 0; i < stride; ++i)
  {
    const Vec3 xi = reference.At(points[std::min(i, points.size() - 1)]);
    for (int d = 0; d < 3; ++d)
    {
      arrays[12 + d][i] = xi[d];
    }
  }
  KernelsFor(space).gradient(space, mesh_.map.Coefficients(element), 3,
    { { arrays[12], arrays[13], arrays[14] }, count }, arrays, arrays + 3);
  const double size = mesh_.size[element];
  const double* centre = &mesh_.centre[3 * static_cast<std::size_t>(element)];
  samples.resize(points.size());
  for (int i = 0; i < count; ++i)
  {
    FaceSample& sample = samples[static_cast<std::size_t>(i)];
    Mat3 jacobian;
    for (int c = 0; c < 3; ++c)
    {
      sample.x[c] = std::fma(size, arrays[c][i], centre[c]);
      for (int d = 0; d < 3; ++d)
      {
        jacobian[d][c] = arrays[3 + 3 * c + d][i];
      }
    }
    sample.first = jacobian * reference.First();
    sample.second = jacobian * reference.Second();
    const double determinant = glm::determinant(jacobian);
    const double side = determinant > 0.0 ? 1.0 : determinant < 0.0 ? -1.0 : 0.0;
    sample.normal = side * glm::cross(sample.first, sample.second);
  }
}

FaceGrids::FaceGrids(int highestOrder)
{
  for (int order = 1; order <= std::max(highestOrder, 1); ++order)
  {
    const auto closed = GaussLobattoPoints(order + 1);
    const auto open = GaussPoints(std::max(kMinOpenPoints, (order + 2) / 2 * 2));
    for (int corners = 3; corners <= 4; ++corners)
    {
      ClosedGrids[corners - 3].push_back(Grid(closed, corners));
      OpenGrids[corners - 3].push_back(Grid(open, corners));
    }
  }
}

std::span<const FacePoint> FaceGrids::Closed(int corners, int order) const
{
  return ClosedGrids[corners - 3][static_cast<std::size_t>(std::max(order, 1)) - 1];
}

std::span<const FacePoint> FaceGrids::Open(int corners, int order) const
{
  return OpenGrids[corners - 3][static_cast<std::size_t>(std::max(order, 1)) - 1];
}
} // namespace pixelexact
