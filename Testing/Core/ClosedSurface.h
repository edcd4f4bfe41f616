// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/LineFunctions.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Element/Transform.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Mat.h"
#include "Core/Shape/ShapeFace.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

// Checks by Gauss' theorem that the boundary faces of a mesh are closed, with quadrature in eta and
// the signs of the shapes' table.
namespace pixelexact::testing
{
struct SurfaceIntegrals
{
  Vec3 area{ 0.0 };     ///< integral of the outward unit normal: 0 of a closed surface
  double volume = 0.0;  ///< a third of that of x . n, from the centre of the mesh
  double inside = 0.0;  ///< that of |det J| over the elements
  double surface = 0.0; ///< area of the surface
};

struct Quadrature
{
  explicit Quadrature(int n)
  {
    for (const long double x : GaussPoints(n))
    {
      long double before = 1;
      long double p = x;
      for (int k = 2; k <= n; ++k)
      {
        const long double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      const long double derivative = n * (before - x * p) / (1 - x * x);
      points.push_back(static_cast<double>(x));
      weights.push_back(static_cast<double>(2 / ((1 - x * x) * derivative * derivative)));
    }
  }
  std::vector<double> points;
  std::vector<double> weights;
};

/// dxi / deta_d; xi is affine in each eta.
inline Vec3 TensorColumn(Shape shape, Vec3 eta, int d)
{
  eta[d] = 1.0;
  const Vec3 upper = TensorToReference(shape, eta);
  eta[d] = -1.0;
  return (upper - TensorToReference(shape, eta)) / 2.0;
}

inline SurfaceIntegrals IntegrateBoundary(const Mesh& mesh, const FaceTable& faces)
{
  SurfaceIntegrals result;
  int order = 1;
  for (const Space& space : mesh.map.spaces)
  {
    order = std::max(order, space.MaxOrder());
  }
  const Quadrature rule(2 * order + 2);
  const int n = static_cast<int>(rule.points.size());
  Vec3 middle(0.0);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    for (int d = 0; d < 3; ++d)
    {
      middle[d] += mesh.centre[3 * static_cast<std::size_t>(e) + d] / mesh.Elements();
    }
  }
  const auto evaluate =
    [&](int e, const std::vector<Vec3>& eta, std::vector<Vec3>& x, std::vector<Mat3>& columns)
  {
    std::vector<Vec3> xi(eta.size());
    std::ranges::transform(
      eta, xi.begin(), [&](const Vec3& at) { return TensorToReference(mesh.ShapeOf(e), at); });
    x.resize(xi.size());
    MapForward(mesh, e, xi, x);
    columns = Jacobians(mesh, e, LaneBuffer(xi).View());
    for (std::size_t i = 0; i < xi.size(); ++i)
    {
      Mat3 tensor;
      for (int d = 0; d < 3; ++d)
      {
        tensor[d] = TensorColumn(mesh.ShapeOf(e), eta[i], d);
      }
      columns[i] = columns[i] * tensor * mesh.size[e];
    }
  };
  std::vector<Vec3> x;
  std::vector<Mat3> columns;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    std::vector<Vec3> eta;
    std::vector<double> weights;
    for (int i = 0; i < n * n * n; ++i)
    {
      const int at[3] = { i % n, i / n % n, i / n / n };
      eta.emplace_back(rule.points[at[0]], rule.points[at[1]], rule.points[at[2]]);
      weights.push_back(rule.weights[at[0]] * rule.weights[at[1]] * rule.weights[at[2]]);
    }
    evaluate(e, eta, x, columns);
    for (std::size_t i = 0; i < eta.size(); ++i)
    {
      result.inside += weights[i] * std::fabs(glm::determinant(columns[i]));
    }
    int face = 0;
    for (const ShapeFace& end : FacesOf(mesh.ShapeOf(e)))
    {
      if (faces.KindOf(e, face++) != FaceKind::Boundary)
      {
        continue;
      }
      const int u = (end.direction + 1) % 3;
      const int v = (end.direction + 2) % 3;
      eta.clear();
      weights.clear();
      for (int i = 0; i < n * n; ++i)
      {
        Vec3 at;
        at[end.direction] = end.upper ? 1.0 : -1.0;
        at[u] = rule.points[i % n];
        at[v] = rule.points[i / n];
        eta.push_back(at);
        weights.push_back(rule.weights[i % n] * rule.weights[i / n]);
      }
      evaluate(e, eta, x, columns);
      for (std::size_t i = 0; i < eta.size(); ++i)
      {
        const double side = std::copysign(1.0, glm::determinant(columns[i])) * (end.upper ? 1 : -1);
        const Vec3 normal = side * glm::cross(columns[i][u], columns[i][v]);
        result.area += weights[i] * normal;
        result.volume += weights[i] * glm::dot(x[i] - middle, normal) / 3.0;
        result.surface += weights[i] * glm::length(normal);
      }
    }
  }
  return result;
}

inline double LargestOf(const Vec3& v)
{
  return std::max({ std::fabs(v.x), std::fabs(v.y), std::fabs(v.z) });
}
} // namespace pixelexact::testing
