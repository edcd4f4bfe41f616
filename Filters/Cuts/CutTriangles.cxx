// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/CutTriangles.h"

#include "Core/Base/Counted.h"
#include "Core/Math/Rounding.h"
#include "Cuts/MarchedCubes.h"
#include "Grids/FilterWork.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pixelexact
{
namespace
{
constexpr const char* kRemedy = "lower the resolution";
/// Of three numbers each, two to a point.
constexpr double kBytesOfTriangles = 48.0;

double Longest(const Vec3& sides)
{
  return std::max({ sides.x, sides.y, sides.z });
}

/// Where a plane crosses the edges of a box.
std::vector<Vec3> CrossingsOf(const Vec3& point, const Vec3& normal, const Box3& box)
{
  std::vector<Vec3> crossings;
  const auto corner = [&box](int c)
  {
    return Vec3((c & 1) != 0 ? box.upper.x : box.lower.x, (c & 2) != 0 ? box.upper.y : box.lower.y,
      (c & 4) != 0 ? box.upper.z : box.lower.z);
  };
  for (int a = 0; a < 8; ++a)
  {
    for (int side = 1; side < 8; side *= 2)
    {
      const Vec3 p = corner(a);
      const Vec3 q = corner(a | side);
      const double atP = glm::dot(normal, p - point);
      const double atQ = glm::dot(normal, q - point);
      if ((a & side) == 0 && (atP <= 0.0) != (atQ <= 0.0))
      {
        crossings.push_back(p + (q - p) * (atP / (atP - atQ)));
      }
    }
  }
  return crossings;
}

CutTriangles PlaneGrid(
  const QuadricForm& form, const Box3& box, int resolution, double bytesPerPoint)
{
  const double length = glm::length(form.g);
  const Vec3 normal = form.g / length;
  const Vec3 point = form.origin - normal * (form.c / length);
  // The axis that is most nearly in the plane leads one way.
  const Vec3 slant = glm::abs(normal);
  const int axis = slant.x <= slant.y && slant.x <= slant.z ? 0 : (slant.y <= slant.z ? 1 : 2);
  Vec3 along(0.0);
  along[axis] = 1.0;
  const Vec3 u = glm::normalize(along - normal * normal[axis]);
  const Vec3 v = glm::cross(normal, u);

  CutTriangles cut;
  double lower[2] = { kInfinity, kInfinity };
  double upper[2] = { -kInfinity, -kInfinity };
  for (const Vec3& x : CrossingsOf(point, normal, box))
  {
    const double at[2] = { glm::dot(u, x - point), glm::dot(v, x - point) };
    for (int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], at[d]);
      upper[d] = std::max(upper[d], at[d]);
    }
  }
  const double sides[2] = { upper[0] - lower[0], upper[1] - lower[1] };
  const double longest = std::max(sides[0], sides[1]);
  if (!(longest > 0.0))
  {
    return cut;
  }
  std::int64_t n[2];
  for (int d = 0; d < 2; ++d)
  {
    n[d] = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::ceil(resolution * (sides[d] / longest) - 1e-9)));
  }
  const double points = static_cast<double>(n[0] + 1) * static_cast<double>(n[1] + 1);
  RequireMemory(points * (sizeof(Vec3) + kBytesOfTriangles + bytesPerPoint),
    Counted(n[0] * n[1], "square") + " on the plane", kRemedy);
  cut.points.reserve(static_cast<std::size_t>(points));
  for (std::int64_t j = 0; j <= n[1]; ++j)
  {
    for (std::int64_t i = 0; i <= n[0]; ++i)
    {
      const double s = lower[0] + sides[0] * static_cast<double>(i) / static_cast<double>(n[0]);
      const double t = lower[1] + sides[1] * static_cast<double>(j) / static_cast<double>(n[1]);
      cut.points.push_back(point + u * s + v * t);
    }
  }
  cut.triangles.reserve(static_cast<std::size_t>(2 * n[0] * n[1]));
  for (std::int64_t j = 0; j < n[1]; ++j)
  {
    for (std::int64_t i = 0; i < n[0]; ++i)
    {
      const std::int64_t a = j * (n[0] + 1) + i;
      const std::int64_t b = a + n[0] + 1;
      cut.triangles.push_back({ a, a + 1, b + 1 });
      cut.triangles.push_back({ a, b + 1, b });
    }
  }
  return cut;
}
} // namespace

std::int64_t BringOntoSurface(
  const CutFunction& cut, std::span<const double> reach, std::span<Vec3> x)
{
  constexpr int kMostSteps = 50;
  std::int64_t off = 0;
  std::vector<std::size_t> moving(x.size());
  std::iota(moving.begin(), moving.end(), std::size_t{ 0 });
  std::vector<Vec3> at(x.begin(), x.end());
  std::vector<double> values(x.size());
  std::vector<Vec3> gradients(x.size());
  for (int i = 0; i < kMostSteps && !moving.empty(); ++i)
  {
    cut.Values(at, values);
    cut.Gradients(at, gradients);
    std::size_t next = 0;
    for (std::size_t k = 0; k < moving.size(); ++k)
    {
      Vec3& start = x[moving[k]];
      const double most = reach[moving[k]];
      const Vec3 step = gradients[k] * (values[k] / glm::dot(gradients[k], gradients[k]));
      const bool arrived = values[k] == 0.0 || glm::length(step) <= 1e-15 * most;
      const Vec3 then = arrived ? at[k] : at[k] - step;
      if (!arrived && !(glm::distance(then, start) <= most))
      {
        ++off;
      }
      // Rounding of far coordinates lets steps become no smaller than this.
      else if (arrived || glm::length(step) <= 4e-16 * Longest(glm::abs(then)) ||
        i + 1 == kMostSteps)
      {
        start = then;
      }
      else
      {
        moving[next] = moving[k];
        at[next++] = then;
      }
    }
    moving.resize(next);
    at.resize(next);
    values.resize(next);
    gradients.resize(next);
  }
  return off;
}

CutTriangles TriangulateCut(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress)
{
  if (!(box.lower.x <= box.upper.x) || !(Longest(box.upper - box.lower) > 0.0))
  {
    return {};
  }
  const QuadricForm* form = cut.Quadric();
  return form != nullptr && form->IsPlane()
    ? PlaneGrid(*form, box, resolution, bytesPerPoint)
    : MarchCubes(cut, box, resolution, kBytesOfTriangles + bytesPerPoint, progress);
}
} // namespace pixelexact
