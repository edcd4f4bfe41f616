// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Formats/Nektar/Geometry/Geometry.h"

#include <functional>
#include <map>

namespace pixelexact::nektar
{
/// The maps from edges and faces to world space. A face with points of its own is their
/// interpolation. One without is filled from its edges with the modified basis: on triangles the
/// bubbles of the first edge decay towards the third vertex as ((1 - eta2) / 2)^p.
class FaceMaps
{
public:
  /// Prepares every curve of the geometry, which must outlive this object. Safe to use from several
  /// threads.
  explicit FaceMaps(const Geometry& geometry);

  /// The point of a face for weights of its vertices, in the face's own order of vertices: bilinear
  /// on quadrilaterals, barycentric on triangles.
  [[nodiscard]] LongVec3 At(const Face& face, const std::array<long double, 4>& weights) const;

  /// The highest order of a face's curve and of its edges' curves.
  [[nodiscard]] int OrderOf(const Face& face) const;

private:
  /// The difference of edge k from the straight line between its ends, at z in [-1,1].
  using EdgeBubble = std::function<LongVec3(int k, long double z)>;

  [[nodiscard]] LongVec3 Vertex(std::int64_t id) const;
  [[nodiscard]] LongVec3 AtEdge(const Edge& edge, std::int64_t from, long double z) const;
  [[nodiscard]] LongVec3 Bubble(const Edge& edge, std::int64_t from, long double z) const;
  [[nodiscard]] LongVec3 Fill(const Face& face, const std::array<long double, 4>& weights) const;
  [[nodiscard]] LongVec3 FillQuadrilateral(const Face& face, long double s, long double t) const;
  /// A triangle filled from its edges' differences from straight lines; `order` is that of the
  /// first edge.
  [[nodiscard]] LongVec3 FillTriangle(
    int order, const std::array<long double, 4>& weights, const EdgeBubble& bubble) const;
  [[nodiscard]] LongVec3 TriangleBubble(const Face& face, int k, long double z) const;
  /// The difference between the edges' own curves and a triangle's interpolation. As in Nektar++
  /// the edges' curves take precedence where rounded tabulated points differ from them.
  [[nodiscard]] LongVec3 FromEdges(
    const Face& face, const Curve& curve, const std::array<long double, 4>& weights) const;
  [[nodiscard]] LongVec3 Interpolate(
    const Curve& curve, const std::array<long double, 4>& weights) const;

  const Geometry& Source;
  /// Per distribution and order: functions of a line's points, or of a triangle's.
  std::map<std::pair<Distribution, int>, LineFunctions> Lines;
  std::map<std::pair<Distribution, int>, BasisFactor> Triangles;
  /// Per order: from a bubble's values at the Gauss points to its coefficients in A_2, A_3, ...
  std::map<int, BasisFactor> Bubbles;
};
} // namespace pixelexact::nektar
