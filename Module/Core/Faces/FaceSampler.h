// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Faces/ReferenceFace.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// An element's face at one of its points.
struct FaceSample
{
  Vec3 x{ 0.0 };      ///< world
  Vec3 first{ 0.0 };  ///< derivative by the FacePoint's first number, in the element's units
  Vec3 second{ 0.0 }; ///< by its second
  Vec3 normal{ 0.0 }; ///< out of the element: the tangents' product; 0 where det J is
};

/// Evaluates faces of a mesh's elements. Keeps scratch arrays: each thread makes its own.
class FaceSampler
{
public:
  explicit FaceSampler(const Mesh& mesh)
    : mesh_(mesh)
  {
  }

  /// One sample for each point, valid until the next call with the same vector.
  void Sample(
    int element, int face, std::span<const FacePoint> points, std::vector<FaceSample>& samples);

private:
  const Mesh& mesh_;
  std::vector<double> Lanes;
};

/// Sample points of faces, to compare them and to find their neighbours, for polynomials of every
/// order of a mesh.
class FaceGrids
{
public:
  explicit FaceGrids(int highestOrder);

  /// (n + 1)^2 points, corners and edges included, whose values bound a polynomial of order n (at
  /// least 1): the Gauss-Lobatto-Legendre points; in triangles collapsed towards a corner.
  [[nodiscard]] std::span<const FacePoint> Closed(int corners, int order) const;
  /// Points off the edges, at least 16 and as many as `Closed` has: Gauss-Legendre points of an
  /// even number, so that none lies in the middle, where hanging faces usually meet.
  [[nodiscard]] std::span<const FacePoint> Open(int corners, int order) const;

private:
  using Grids = std::vector<std::vector<FacePoint>>; ///< by order
  Grids ClosedGrids[2];                              ///< of triangles, of quadrilaterals
  Grids OpenGrids[2];
};
} // namespace pixelexact
