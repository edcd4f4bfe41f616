// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceSampler.h"

namespace pixelexact
{
/// The normals of coinciding faces are opposite, up to what their uncertainty turns them by: the
/// largest cosine of their angle.
inline constexpr double kOpposite = -0.5;

/// Finds points of a face. Keeps scratch arrays: each thread makes its own.
class FaceProjection
{
public:
  FaceProjection(const Mesh& mesh, const FaceGrids& grids)
    : mesh_(mesh)
    , Grids(grids)
    , Sampler(mesh)
  {
  }

  /// Finds the points that lie on the face, up to a distance per coordinate, with the element on
  /// the side opposite to their elements; the points' normals point out of their elements.
  /// Gauss-Newton's iteration from the nearest point of the closed grid: it may miss a point of a
  /// face that winds more than its order explains, and finds none that does not exist.
  void Find(int element, int face, std::span<const FaceSample> points, const Vec3& tolerance,
    std::vector<char>& found);

private:
  const Mesh& mesh_;
  const FaceGrids& Grids;
  FaceSampler Sampler;
  std::vector<FaceSample> Samples;
  std::vector<FacePoint> At;
  std::vector<int> Left; ///< steps, per point
};
} // namespace pixelexact
