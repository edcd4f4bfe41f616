// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/ReferenceFace.h"

#include "Core/Shape/ShapeFace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

namespace pixelexact
{
namespace
{
ReferenceFace Make(Shape shape, const ShapeFace& end)
{
  constexpr double kTurn[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
  std::vector<Vec3> corners;
  for (const auto& [first, second] : kTurn)
  {
    Vec3 eta;
    eta[end.direction] = end.upper ? 1.0 : -1.0;
    eta[(end.direction + 1) % 3] = first;
    eta[(end.direction + 2) % 3] = second;
    // Exact: a collapsed edge's two ends are equal.
    const Vec3 xi = TensorToReference(shape, eta);
    if (std::ranges::find(corners, xi) == corners.end())
    {
      corners.push_back(xi);
    }
  }
  const Vec3 normal = glm::cross(corners[1] - corners[0], corners.back() - corners[0]);
  if (glm::dot(normal, corners[0] - Centre(shape)) < 0.0)
  {
    std::reverse(corners.begin() + 1, corners.end());
  }
  ReferenceFace face;
  face.corners = static_cast<int>(corners.size());
  std::ranges::copy(corners, face.corner.begin());
  return face;
}

std::vector<std::vector<ReferenceFace>> MakeAll()
{
  std::vector<std::vector<ReferenceFace>> all(kShapeCount);
  for (int s = 0; s < kShapeCount; ++s)
  {
    const auto shape = static_cast<Shape>(s);
    for (const ShapeFace& end : FacesOf(shape))
    {
      all[static_cast<std::size_t>(s)].push_back(Make(shape, end));
    }
  }
  return all;
}
} // namespace

FacePoint ReferenceFace::Nearest(const FacePoint& point) const
{
  auto [a, b] = point;
  if (const double beyond = a + b - 1.0; corners == 3 && beyond > 0.0)
  {
    a -= beyond / 2.0;
    b -= beyond / 2.0;
  }
  a = std::clamp(a, 0.0, 1.0);
  b = std::clamp(b, 0.0, 1.0);
  return { a, corners == 3 ? std::min(b, 1.0 - a) : b };
}

const ReferenceFace& ReferenceFaceOf(Shape shape, int face)
{
  static const auto all = MakeAll();
  return all[static_cast<std::size_t>(shape)][static_cast<std::size_t>(face)];
}
} // namespace pixelexact
