// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LongMap.h"

#include "Core/Contour/Contour.h"
#include "Core/Location/Locator.h"
#include "Core/Location/Sample.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <numeric>

// Contours of fields given in closed form, measured.
namespace pixelexact::testing
{
using LongScalar = std::function<long double(const LongVec3& x)>;

/// A scalar field on a mesh that has a polynomial's values: the polynomial, where it lies in the
/// space of this order.
inline ExpansionBuilder FieldOf(const Mesh& mesh, int order, const LongScalar& function)
{
  ExpansionBuilder builder(1);
  LongMap map(mesh);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    builder.Add(UniformSpace(mesh.ShapeOf(e), order),
      [&](const LongVec3& xi, long double* values) { *values = function(map(e, xi)); });
  }
  return builder;
}

/// The contours of a mesh and a field of one component.
inline ContourSet ContoursOf(const Mesh& mesh, const ExpansionBuilder& values,
  const CutFunction& cut, std::vector<double> levels, double tolerance)
{
  const Field field{ "f", values.View() };
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  return TraceContours({ mesh, &field, 0, &cut }, locator, faces, { std::move(levels), tolerance });
}

/// Into how many regions the square z = const of the element [-1,1]^3 falls by where the field is
/// above the value, seen at pixels.
inline std::size_t CountRegions(
  const Mesh& mesh, const Field& field, double z, double value, int pixels)
{
  std::vector<bool> above;
  for (int j = 0; j < pixels; ++j)
  {
    std::vector<Vec3> xi;
    for (int i = 0; i < pixels; ++i)
    {
      xi.emplace_back((2.0 * i + 1.0) / pixels - 1.0, (2.0 * j + 1.0) / pixels - 1.0, z);
    }
    std::vector<double> row(xi.size());
    EvaluateAt(mesh, field, 0, xi, row, {});
    for (const double one : row)
    {
      above.push_back(one > value);
    }
  }
  std::vector<int> root(above.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int at)
  {
    while (root[at] != at)
    {
      at = root[at] = root[root[at]];
    }
    return at;
  };
  for (int at = 0; at < static_cast<int>(root.size()); ++at)
  {
    for (const int next : { at % pixels + 1 < pixels ? at + 1 : at, at + pixels })
    {
      if (next < static_cast<int>(root.size()) && above[at] == above[next])
      {
        root[find(at)] = find(next);
      }
    }
  }
  std::size_t regions = 0;
  for (int at = 0; at < static_cast<int>(root.size()); ++at)
  {
    regions += root[at] == at ? 1 : 0;
  }
  return regions;
}

/// The largest |F(x) - rho| and |S(x)| of the vertices, x from their xi in long double, and
/// distance of x from the vertices' own.
struct VertexErrors
{
  long double value = 0.0L;
  long double cut = 0.0L;
  long double place = 0.0L;
};
inline VertexErrors ErrorsOf(const ContourSet& set, const Mesh& mesh,
  const std::vector<double>& levels, const LongScalar& f, const LongScalar& s)
{
  VertexErrors errors;
  LongMap map(mesh);
  for (const ContourLine& line : set.lines)
  {
    for (const std::int64_t id : line.vertices)
    {
      const ContourVertex& vertex = set.vertices[static_cast<std::size_t>(id)];
      const LongVec3 x = map(vertex.element, ToLong(vertex.xi));
      errors.value = std::max(errors.value, std::fabs(f(x) - levels[line.value]));
      errors.cut = std::max(errors.cut, std::fabs(s(x)));
      errors.place = std::max(errors.place, Largest(Minus(x, ToLong(vertex.x))));
    }
  }
  return errors;
}

/// Length of a line, and the area that its shadow on z = 0 encloses: of the cubics with the curve's
/// points and directions at the vertices, the latter from the gradients. Off by the fourth power of
/// the angles between vertices.
struct LineMeasure
{
  double length = 0.0;
  double area = 0.0;
};
inline LineMeasure Measure(const ContourSet& set, const ContourLine& line, const CutFunction& cut)
{
  constexpr double kPoint[5] = { 0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
    0.953089922969332 };
  constexpr double kWeight[5] = { 0.118463442528095, 0.239314335249683, 0.284444444444444,
    0.239314335249683, 0.118463442528095 };
  LineMeasure measure;
  for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i)
  {
    const auto at = [&](std::size_t k) -> const ContourVertex&
    { return set.vertices[static_cast<std::size_t>(line.vertices[k])]; };
    const Vec3 chord = at(i + 1).x - at(i).x;
    const auto direction = [&](const ContourVertex& vertex)
    {
      const Vec3 along = glm::normalize(glm::cross(vertex.gradient, cut.Gradient(vertex.x)));
      return glm::dot(along, chord) < 0.0 ? -along : along;
    };
    const Vec3 from = direction(at(i));
    const Vec3 to = direction(at(i + 1));
    // An arc is longer than its chord by the square of its angle over 24.
    const double angle = glm::length(to - from);
    const double speed = glm::length(chord) * (1.0 + angle * angle / 24.0);
    for (int k = 0; k < 5; ++k)
    {
      const double t = kPoint[k];
      const Vec3 slope = 6.0 * t * (1.0 - t) * chord +
        speed * ((1.0 - t) * (1.0 - 3.0 * t) * from + t * (3.0 * t - 2.0) * to);
      const Vec3 x = at(i).x + t * t * (3.0 - 2.0 * t) * chord +
        speed * (t * (1.0 - t) * (1.0 - t) * from - t * t * (1.0 - t) * to);
      measure.length += kWeight[k] * glm::length(slope);
      measure.area += kWeight[k] * 0.5 * (x.x * slope.y - x.y * slope.x);
    }
  }
  measure.area = std::fabs(measure.area);
  return measure;
}
} // namespace pixelexact::testing
