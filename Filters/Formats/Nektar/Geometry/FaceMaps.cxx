// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/FaceMaps.h"

#include "Formats/Nektar/Geometry/CurvePoints.h"
#include "Formats/Nektar/Geometry/ReferenceShapes.h"

#include <algorithm>
#include <cmath>

namespace pixelexact::nektar
{
namespace
{
constexpr int kCornerSign[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
/// A triangle's edges in the directions in which it is filled from them.
constexpr int kTriangleEdges[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };

void Add(LongVec3& sum, long double factor, const LongVec3& x)
{
  for (int d = 0; d < 3; ++d)
  {
    sum[d] += factor * x[d];
  }
}

LongVec3 ToLong(const Point& x)
{
  return { x[0], x[1], x[2] };
}

Space TriangleSpace(int order)
{
  const auto n = static_cast<std::uint8_t>(order);
  return { Shape::Prism, Form::Collapsed, { n, 0, n } };
}

/// The triangle of the prism: vertex 1 lies at xi1 = 1, vertex 2 at xi3 = 1.
LongVec3 TriangleXi(long double first, long double second)
{
  return { 2 * first - 1, 0, 2 * second - 1 };
}

std::vector<long double> Identity(int n)
{
  std::vector<long double> matrix(static_cast<std::size_t>(n) * n, 0.0L);
  for (int i = 0; i < n; ++i)
  {
    matrix[static_cast<std::size_t>(i) * (n + 1)] = 1.0L;
  }
  return matrix;
}

BasisFactor TriangleFactor(Distribution distribution, int order)
{
  const Space space = TriangleSpace(order);
  const int n = space.Modes();
  std::vector<long double> modes(static_cast<std::size_t>(n) * n);
  const auto points = TrianglePoints(distribution, order);
  for (int i = 0; i < n; ++i)
  {
    EvaluateModes(space, TriangleXi(points[i][1], points[i][2]), &modes[std::size_t(i) * n]);
  }
  return SolveFactor(n, n, modes, Identity(n));
}

BasisFactor BubbleFactor(int order)
{
  const int n = order - 1;
  const auto points = GaussPoints(n);
  std::vector<long double> modes;
  for (const long double z : points)
  {
    for (int p = 2; p <= order; ++p)
    {
      modes.push_back(ModifiedA(p, z));
    }
  }
  return SolveFactor(n, n, modes, Identity(n));
}
} // namespace

FaceMaps::FaceMaps(const Geometry& geometry)
  : Source(geometry)
{
  for (const Curve& curve : geometry.curves)
  {
    const std::pair key(curve.distribution, curve.order);
    const bool triangular = IsTriangular(curve.distribution);
    if (triangular && !Triangles.contains(key))
    {
      Triangles[key] = TriangleFactor(curve.distribution, curve.order);
    }
    if (!triangular && !Lines.contains(key))
    {
      Lines[key] = Lagrange(LinePoints(curve.distribution, curve.order));
    }
    if (curve.order > 1 && !Bubbles.contains(curve.order))
    {
      Bubbles[curve.order] = BubbleFactor(curve.order);
    }
  }
}

LongVec3 FaceMaps::Vertex(std::int64_t id) const
{
  return ToLong(Source.vertices.at(id));
}

int FaceMaps::OrderOf(const Face& face) const
{
  int order = face.curve >= 0 ? Source.curves[face.curve].order : 1;
  for (const auto id : std::span(face.edges).first(face.corners))
  {
    const int curve = Source.edges.at(id).curve;
    order = std::max(order, curve >= 0 ? Source.curves[curve].order : 1);
  }
  return order;
}

LongVec3 FaceMaps::AtEdge(const Edge& edge, std::int64_t from, long double z) const
{
  // The edge's own coordinate, from its first vertex to its second.
  const long double own = edge.vertices[0] == from ? z : -z;
  LongVec3 x{};
  if (edge.curve < 0)
  {
    Add(x, (1 - own) / 2, Vertex(edge.vertices[0]));
    Add(x, (1 + own) / 2, Vertex(edge.vertices[1]));
    return x;
  }
  const Curve& curve = Source.curves[edge.curve];
  std::vector<long double> values(curve.order + 1);
  Lines.at({ curve.distribution, curve.order }).evaluate(own, values.data());
  for (int i = 0; i <= curve.order; ++i)
  {
    Add(x, values[i], ToLong(curve.points[i]));
  }
  return x;
}

LongVec3 FaceMaps::Bubble(const Edge& edge, std::int64_t from, long double z) const
{
  LongVec3 x{};
  if (edge.curve >= 0)
  {
    x = AtEdge(edge, from, z);
    Add(x, -(1 - z) / 2, AtEdge(edge, from, -1));
    Add(x, -(1 + z) / 2, AtEdge(edge, from, 1));
  }
  return x;
}

LongVec3 FaceMaps::FillQuadrilateral(const Face& face, long double s, long double t) const
{
  const auto edge = [&](int k) -> const Edge& { return Source.edges.at(face.edges[k]); };
  LongVec3 x{};
  Add(x, (1 - t) / 2, Bubble(edge(0), face.vertices[0], s));
  Add(x, (1 + s) / 2, Bubble(edge(1), face.vertices[1], t));
  Add(x, (1 + t) / 2, Bubble(edge(2), face.vertices[3], s));
  Add(x, (1 - s) / 2, Bubble(edge(3), face.vertices[0], t));
  return x;
}

LongVec3 FaceMaps::FillTriangle(
  int order, const std::array<long double, 4>& weights, const EdgeBubble& bubble) const
{
  const long double base = weights[0] + weights[1];
  const long double eta1 = base > 0 ? (weights[1] - weights[0]) / base : 0.0L;
  const long double eta2 = 2 * weights[2] - 1;
  LongVec3 x{};
  Add(x, (1 + eta1) / 2, bubble(1, eta2));
  Add(x, (1 - eta1) / 2, bubble(2, eta2));
  if (order < 2)
  {
    return x;
  }
  const BasisFactor& factor = Bubbles.at(order);
  const auto points = GaussPoints(factor.columns);
  for (int i = 0; i < factor.columns; ++i)
  {
    // The sum of the bubble's modes for this sample point.
    long double weight = 0.0L;
    for (int p = 2; p <= order; ++p)
    {
      weight += factor.matrix[std::size_t(p - 2) * factor.columns + i] * ModifiedA(p, eta1) *
        std::pow((1 - eta2) / 2, p);
    }
    Add(x, weight, bubble(0, points[i]));
  }
  return x;
}

LongVec3 FaceMaps::TriangleBubble(const Face& face, int k, long double z) const
{
  return Bubble(Source.edges.at(face.edges[k]), face.vertices[kTriangleEdges[k][0]], z);
}

LongVec3 FaceMaps::Fill(const Face& face, const std::array<long double, 4>& weights) const
{
  LongVec3 x{};
  long double s = 0.0L;
  long double t = 0.0L;
  for (int k = 0; k < face.corners; ++k)
  {
    Add(x, weights[k], Vertex(face.vertices[k]));
    s += weights[k] * kCornerSign[k][0];
    t += weights[k] * kCornerSign[k][1];
  }
  if (face.corners == 4)
  {
    Add(x, 1, FillQuadrilateral(face, s, t));
    return x;
  }
  const int curve = Source.edges.at(face.edges[0]).curve;
  Add(x, 1,
    FillTriangle(curve >= 0 ? Source.curves[curve].order : 1, weights,
      [&](int k, long double z) { return TriangleBubble(face, k, z); }));
  return x;
}

LongVec3 FaceMaps::FromEdges(
  const Face& face, const Curve& curve, const std::array<long double, 4>& weights) const
{
  const auto difference = [&](int k, long double z)
  {
    LongVec3 x{};
    const int own = Source.edges.at(face.edges[k]).curve;
    if (own < 0 || Source.curves[own].order != curve.order)
    {
      return x;
    }
    const auto& [from, to] = kTriangleEdges[k];
    std::array<long double, 4> at{};
    at[from] = (1 - z) / 2;
    at[to] = (1 + z) / 2;
    Add(x, 1, TriangleBubble(face, k, z));
    Add(x, -1, Interpolate(curve, at));
    Add(x, at[from], ToLong(curve.points[from]));
    Add(x, at[to], ToLong(curve.points[to]));
    return x;
  };
  return FillTriangle(curve.order, weights, difference);
}

LongVec3 FaceMaps::Interpolate(const Curve& curve, const std::array<long double, 4>& weights) const
{
  LongVec3 x{};
  const std::pair key(curve.distribution, curve.order);
  if (const auto triangle = Triangles.find(key); triangle != Triangles.end())
  {
    const BasisFactor& factor = triangle->second;
    std::vector<long double> modes(factor.rows);
    EvaluateModes(TriangleSpace(curve.order), TriangleXi(weights[1], weights[2]), modes.data());
    for (int i = 0; i < factor.columns; ++i)
    {
      long double weight = 0.0L;
      for (int m = 0; m < factor.rows; ++m)
      {
        weight += modes[m] * factor.matrix[std::size_t(m) * factor.columns + i];
      }
      Add(x, weight, ToLong(curve.points[i]));
    }
    return x;
  }
  const int n = curve.order + 1;
  std::vector<long double> alongS(n);
  std::vector<long double> alongT(n);
  const auto& line = Lines.at(key);
  line.evaluate(weights[1] + weights[2] - weights[0] - weights[3], alongS.data());
  line.evaluate(weights[2] + weights[3] - weights[0] - weights[1], alongT.data());
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      Add(x, alongS[i] * alongT[j], ToLong(curve.points[std::size_t(j) * n + i]));
    }
  }
  return x;
}

LongVec3 FaceMaps::At(const Face& face, const std::array<long double, 4>& weights) const
{
  if (face.curve < 0)
  {
    return Fill(face, weights);
  }
  const Curve& curve = Source.curves[face.curve];
  LongVec3 x = Interpolate(curve, weights);
  if (IsTabulated(curve.distribution))
  {
    Add(x, 1, FromEdges(face, curve, weights));
  }
  return x;
}
} // namespace pixelexact::nektar
