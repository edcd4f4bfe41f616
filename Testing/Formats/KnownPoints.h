// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SolverModelViews.h"

#include "Core/LongDual.h"
#include "Core/LongModes.h"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

// Points of a model's elements with what is known there, differentiated in long double.
namespace pixelexact::testing
{
using Slope = LongDual<long double>;
using Curvature = LongDual<Slope>;
using SlopeTriple = std::array<Slope, 3>;

/// A point of an element with its place and the fields' values there, which carry their gradients
/// in the world.
struct KnownPoint
{
  int element = 0;
  Vec3 xi;
  SlopeTriple x;
  std::vector<Slope> values; ///< component by component, field by field
};

/// Stored coefficients times modes.
template <class Number>
std::vector<Number> SumOfModes(
  const Expansion& expansion, int element, const std::array<Number, 3>& xi)
{
  LongModes<Number> modes;
  const double* coefficient = expansion.Coefficients(element);
  const std::vector<Number>& mode = modes(expansion.SpaceOf(element), xi);
  std::vector<Number> sums(expansion.components);
  for (Number& sum : sums)
  {
    for (const Number& value : mode)
    {
      sum = sum + *coefficient++ * value;
    }
  }
  return sums;
}

/// An element's map at a point, with derivatives by xi.
struct KnownMap
{
  SlopeTriple x;
  std::array<SlopeTriple, 3> J;        ///< J[i][j]: of x_i by xi_j
  std::array<SlopeTriple, 3> cofactor; ///< of J's entries
  Slope det;

  KnownMap(const Mesh& mesh, int element, const Vec3& xi)
  {
    std::array<Curvature, 3> at;
    for (int d = 0; d < 3; ++d)
    {
      at[d] = Curvature::Variable(Slope::Variable(xi[d], d), d);
    }
    const auto phi = SumOfModes(mesh.map, element, at);
    for (int i = 0; i < 3; ++i)
    {
      const Curvature place =
        mesh.centre[3 * std::size_t(element) + i] + mesh.size[element] * phi[i];
      x[i] = place.value;
      J[i] = place.derivative;
    }
    for (int i = 0; i < 3; ++i)
    {
      const SlopeTriple& a = J[(i + 1) % 3];
      const SlopeTriple& b = J[(i + 2) % 3];
      for (int j = 0; j < 3; ++j)
      {
        cofactor[i][j] = a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3];
      }
    }
    det = J[0][0] * cofactor[0][0] + J[0][1] * cofactor[0][1] + J[0][2] * cofactor[0][2];
  }

  /// Values of H(div) or H(curl) from those in reference space.
  [[nodiscard]] std::vector<Slope> Mapped(Mapping mapping, const std::vector<Slope>& f) const
  {
    const auto& rows = mapping == Mapping::Contravariant ? J : cofactor;
    std::vector<Slope> values(3);
    for (int i = 0; i < 3; ++i)
    {
      values[i] = (rows[i][0] * f.at(0) + rows[i][1] * f.at(1) + rows[i][2] * f.at(2)) / det;
    }
    return values;
  }

  /// The derivatives in world space of derivatives by xi.
  [[nodiscard]] Slope InWorld(const Slope& f) const
  {
    Slope world(f.value);
    for (int d = 0; d < 3; ++d)
    {
      for (int j = 0; j < 3; ++j)
      {
        world.derivative[d] += f.derivative[j] * cofactor[d][j].value / det.value;
      }
    }
    return world;
  }
};

/// The variables at xi, or the places' coordinates.
inline SlopeTriple VariablesAt(const Vec3& xi)
{
  return { Slope::Variable(xi.x, 0), Slope::Variable(xi.y, 1), Slope::Variable(xi.z, 2) };
}

/// A point without values.
inline KnownPoint MakePoint(const KnownMap& map, int element, const Vec3& xi)
{
  KnownPoint point{ element, xi, {}, {} };
  std::ranges::transform(map.x, point.x.begin(), [&](const Slope& x) { return map.InWorld(x); });
  return point;
}

/// A point with values from the model's coefficients.
inline KnownPoint PointFromModel(const SolverModel& model, int element, const Vec3& xi)
{
  const KnownMap map(ViewOf(model.mesh), element, xi);
  KnownPoint point = MakePoint(map, element, xi);
  for (const SolverField& field : model.fields)
  {
    auto values = SumOfModes(field.values.View(), element, VariablesAt(xi));
    if (field.mapping != Mapping::Identity)
    {
      values = map.Mapped(field.mapping, values);
    }
    for (const Slope& value : values)
    {
      point.values.push_back(map.InWorld(value));
    }
  }
  return point;
}

/// Points of an element, random in eta. With faces, half of them are on faces, edges and vertices;
/// the pyramid's apex, where the gradient depends on the direction of approach, is left out.
inline std::vector<Vec3> PointsOfElement(Shape shape, int element, int count, bool withFaces)
{
  std::mt19937 random(static_cast<unsigned>(element) + 1);
  const double reach = withFaces ? 1.2 : 1.0;
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count)
  {
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      eta[d] = std::clamp(coordinate(random), -1.0, 1.0);
    }
    if (shape != Shape::Pyramid || eta.z < 1.0)
    {
      points.push_back(TensorToReference(shape, eta));
    }
  }
  return points;
}
/// Points for each element, some 300 for each model.
inline int PointsForEach(const SolverModel& model)
{
  return std::max(1, 300 / static_cast<int>(model.mesh.number.size()));
}

inline int ElementNumbered(const SolverModel& model, std::int64_t number)
{
  return static_cast<int>(std::ranges::find(model.mesh.number, number) - model.mesh.number.begin());
}
} // namespace pixelexact::testing
