// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/BehindFace.h"

#include "Core/Bounds/ElementBounds.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Faces/FacePlane.h"
#include "Core/Faces/FaceProjection.h"
#include "Core/Math/Mat.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
/// Distance of xi up to which a point that lies on a face may lie on this one.
constexpr double kOnFace = 1e-6;
/// Distance of xi up to which a given point is on a face.
constexpr double kIsOnFace = 1e-9;

std::vector<Mat3> JacobiansAt(const Mesh& mesh, int element, std::span<const Vec3> xi)
{
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  std::vector<double> storage(12 * stride);
  double* arrays[12];
  for (std::size_t k = 0; k < 12; ++k)
  {
    arrays[k] = &storage[k * stride];
  }
  const Space& space = mesh.map.SpaceOf(element);
  const LaneBuffer lanes(xi);
  KernelsFor(space).gradient(
    space, mesh.map.Coefficients(element), 3, lanes.View(), arrays, arrays + 3);
  std::vector<Mat3> jacobians(xi.size());
  for (std::size_t i = 0; i < xi.size(); ++i)
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

/// Out of the element, of length 1; zero where the Jacobian, or the face, has no extent.
Vec3 OutwardNormal(const Mat3& jacobian, const FacePlane& plane)
{
  // The cofactors, times the distance's gradient, which grows inwards.
  const Vec3 normal = -(plane.gradient.x * glm::cross(jacobian[1], jacobian[2]) +
    plane.gradient.y * glm::cross(jacobian[2], jacobian[0]) +
    plane.gradient.z * glm::cross(jacobian[0], jacobian[1]));
  const double length = glm::length(normal);
  const double determinant = glm::determinant(jacobian);
  return length > 0.0 && determinant != 0.0 ? normal * ((determinant > 0.0 ? 1.0 : -1.0) / length)
                                            : Vec3(0.0);
}

class Sink final : public PreimageSink
{
public:
  Sink(const Mesh& mesh, int element, std::span<const Vec3> normals, std::span<BehindFace> behind)
    : mesh_(mesh)
    , Element(element)
    , Normals(normals)
    , Behind(behind)
  {
  }

  void Found(int index, const Preimage& preimage) override
  {
    BehindFace& behind = Behind[static_cast<std::size_t>(index)];
    const bool isBetter = behind.verdict != Verdict::Inside || preimage.element < behind.element;
    if (preimage.element != Element && isBetter &&
      Faces(preimage, Normals[static_cast<std::size_t>(index)]))
    {
      behind = { Verdict::Inside, preimage.element, preimage.xi };
    }
  }

  void Undecided(int index, int element) override
  {
    BehindFace& behind = Behind[static_cast<std::size_t>(index)];
    if (element != Element && behind.verdict == Verdict::Outside)
    {
      behind.verdict = Verdict::Unknown;
    }
  }

private:
  /// Whether the point is on a face of the element that looks against the normal.
  [[nodiscard]] bool Faces(const Preimage& preimage, const Vec3& normal) const
  {
    const Mat3 jacobian = JacobiansAt(mesh_, preimage.element, std::span(&preimage.xi, 1))[0];
    for (const FacePlane& plane : FacePlanesOf(mesh_.ShapeOf(preimage.element)))
    {
      if (std::fabs(plane.Distance(preimage.xi)) <= kOnFace &&
        glm::dot(OutwardNormal(jacobian, plane), normal) < kOpposite)
      {
        return true;
      }
    }
    return false;
  }

  const Mesh& mesh_;
  int Element;
  std::span<const Vec3> Normals;
  std::span<BehindFace> Behind;
};
} // namespace

void FindBehind(const Locator& locator, const ElementFace& face, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<BehindFace> behind)
{
  if (xi.empty())
  {
    return;
  }
  const Mesh& mesh = locator.GetMesh();
  const Vec3 uncertainty = ImageUncertainty(mesh, face.element);
  const double beyond = 2.0 * glm::length(uncertainty);
  const FacePlane& plane =
    FacePlanesOf(mesh.ShapeOf(face.element))[static_cast<std::size_t>(face.face)];
  const std::vector<Mat3> jacobians = JacobiansAt(mesh, face.element, xi);
  std::vector<Vec3> normals(xi.size());
  std::vector<Vec3> points(xi.size());
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    normals[i] = OutwardNormal(jacobians[i], plane);
    points[i] = x[i] + beyond * normals[i];
    behind[i] = {};
  }
  Sink sink(mesh, face.element, normals, behind);
  locator.LocateAll(points, sink);
}

void FindBehindPoints(const Locator& locator, int element, std::span<const Vec3> xi,
  std::span<const Vec3> x, std::span<BehindFace> behind)
{
  std::ranges::fill(behind, BehindFace{});
  const auto planes = FacePlanesOf(locator.GetMesh().ShapeOf(element));
  for (std::size_t f = 0; f < planes.size(); ++f)
  {
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < xi.size(); ++i)
    {
      if (behind[i].verdict != Verdict::Inside && std::fabs(planes[f].Distance(xi[i])) <= kIsOnFace)
      {
        on.push_back(i);
      }
    }
    std::vector<Vec3> xiOn(on.size());
    std::vector<Vec3> xOn(on.size());
    std::vector<BehindFace> found(on.size());
    std::ranges::transform(on, xiOn.begin(), [&](std::size_t i) { return xi[i]; });
    std::ranges::transform(on, xOn.begin(), [&](std::size_t i) { return x[i]; });
    FindBehind(locator, { element, static_cast<std::int32_t>(f) }, xiOn, xOn, found);
    for (std::size_t k = 0; k < on.size(); ++k)
    {
      behind[on[k]] = found[k].verdict == Verdict::Outside ? behind[on[k]] : found[k];
    }
  }
}
} // namespace pixelexact
