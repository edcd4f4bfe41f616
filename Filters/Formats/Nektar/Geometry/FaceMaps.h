// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Formats/Nektar/Geometry/Geometry.h"

#include <functional>
#include <map>

namespace pixelexact::nektar
{
/// The maps of edges and faces to the world. A face with points of its own is their interpolation;
/// one without is filled from its edges with the modified basis: on triangles the bubbles of the
/// first edge decay towards the third vertex as ((1 - eta2) / 2)^p.
class FaceMaps
{
public:
  /// Prepares for every curve of the geometry; the geometry outlives it. Safe to use from several
  /// threads.
  explicit FaceMaps(const Geometry& geometry);

  /// The point of a face at weights of its vertices: bilinear on quadrilaterals, barycentric on
  /// triangles; in the face's own order of vertices.
  [[nodiscard]] LongVec3 At(const Face& face, const std::array<long double, 4>& weights) const;

  /// The highest order of a face's curve and of its edges' curves.
  [[nodiscard]] int OrderOf(const Face& face) const;

private:
  /// What edge k adds to the straight line between its ends, at z.
  using EdgeBubble = std::function<LongVec3(int k, long double z)>;

  [[nodiscard]] LongVec3 Vertex(std::int64_t id) const;
  [[nodiscard]] LongVec3 AtEdge(const Edge& edge, std::int64_t from, long double z) const;
  [[nodiscard]] LongVec3 Bubble(const Edge& edge, std::int64_t from, long double z) const;
  [[nodiscard]] LongVec3 Fill(const Face& face, const std::array<long double, 4>& weights) const;
  [[nodiscard]] LongVec3 FillQuadrilateral(const Face& face, long double s, long double t) const;
  /// A triangle filled from what its edges add to straight ones, the first one's of an order.
  [[nodiscard]] LongVec3 FillTriangle(
    int order, const std::array<long double, 4>& weights, const EdgeBubble& bubble) const;
  [[nodiscard]] LongVec3 TriangleBubble(const Face& face, int k, long double z) const;
  /// What the edges' own curves change of a triangle's interpolation: as in Nektar++ they have the
  /// last word, where the digits of tabulated points leave a difference.
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
