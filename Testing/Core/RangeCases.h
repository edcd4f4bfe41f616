// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"
#include "QuadReference.h"

#include "Core/Element/Ranges.h"

#include <string>

// Elements with fields for the tests of certified ranges, and their quantities in 113 bits.
namespace pixelexact::testing
{
/// One element with one field.
struct RangeCase
{
  RangeCase(const Space& mapSpace, const MeshBuilder::Map& map, const Vec3& centre = Vec3(0.0),
    double size = 1.0)
  {
    builder.Add(mapSpace, map, centre, size);
    mesh = builder.View();
  }

  /// Makes the map of a pyramid's Tensor form single-valued at the apex, exactly.
  void Close()
  {
    const Space& mapSpace = mesh.map.SpaceOf(0);
    auto& modes = builder.Phi.Coefficients;
    double sum = 0.0;
    for (std::size_t c = 0; c < 3 && mapSpace.form == Form::Tensor; ++c)
    {
      ForEachMode(mapSpace,
        [&](int p, int q, int r, int mode)
        {
          double& value =
            modes[c * static_cast<std::size_t>(mapSpace.Modes()) + static_cast<std::size_t>(mode)];
          value = std::round(value * 0x1p40) * 0x1p-40;
          sum = (r == 0 ? 0.0 : sum) + value;
          value -= p + q > 0 && r == mapSpace.LastR(p, q) ? sum : 0.0;
        });
    }
  }

  void SetField(const Space& fieldSpace, std::vector<double> coefficients, int components = 1,
    Mapping mapping = Mapping::Identity)
  {
    space = { fieldSpace };
    values = std::move(coefficients);
    field.name = std::string("f");
    field.values = { space, spaceOf, offset, values, components };
    field.mapping = mapping;
  }

  /// Random modes, each `decay` as large as those of one degree less.
  void SetNoise(int order, Random& random, double decay)
  {
    const Space noise = UniformSpace(mesh.ShapeOf(0), order);
    std::vector<double> modes;
    ForEachMode(noise,
      [&](int p, int q, int r, int) { modes.push_back(random() * std::pow(decay, p + q + r)); });
    SetField(noise, modes);
  }

  MeshBuilder builder;
  Mesh mesh;
  std::vector<Space> space;
  std::vector<std::int32_t> spaceOf{ 0 };
  std::vector<std::int64_t> offset{ 0 };
  std::vector<double> values;
  Field field;
};

/// A quantity at eta; of norms the square. Not at a pyramid's apex.
inline Quad QuantityQuad(const RangeCase& one, const RangeQuestion& question, const Vec3& eta)
{
  const QuadVec3 xi = ToXi(one.mesh.ShapeOf(0), { Quad(eta.x), Quad(eta.y), Quad(eta.z) });
  const auto square = [](const std::vector<Quad>& v)
  {
    Quad sum;
    for (const Quad& c : v)
    {
      sum = sum + c * c;
    }
    return sum;
  };
  if (question.quantity == Quantity::Component || question.quantity == Quantity::Magnitude)
  {
    const auto u = WorldValuesQuad(one.mesh, one.field, 0, xi);
    return question.quantity == Quantity::Magnitude
      ? square(u)
      : u[static_cast<std::size_t>(question.component)];
  }
  const QuadInverse inverse(EvaluateQuad(one.mesh.map, 0, xi));
  const Quad size(one.mesh.size[0]);
  if (question.quantity == Quantity::Jacobian)
  {
    return inverse.Determinant * size * size * size;
  }
  const auto f =
    EvaluateQuad(one.field.values, 0, xi)[static_cast<std::size_t>(question.component)];
  std::vector<Quad> gradient;
  for (int k = 0; k < 3; ++k)
  {
    Quad sum;
    for (std::size_t j = 0; j < 3; ++j)
    {
      sum = sum + inverse.Cofactor[k][j] * f.gradient[j];
    }
    gradient.push_back(sum / inverse.Determinant / size);
  }
  return question.quantity == Quantity::GradientMagnitude
    ? square(gradient)
    : gradient[static_cast<std::size_t>(question.direction)];
}

/// Whether the exact quantity lies in the interval.
inline bool Holds(const Interval& range, const RangeQuestion& question, const Quad& exact)
{
  const bool norm =
    question.quantity == Quantity::Magnitude || question.quantity == Quantity::GradientMagnitude;
  const Quad lower = norm ? Quad(range.lower) * Quad(range.lower) : Quad(range.lower);
  const Quad upper = norm ? Quad(range.upper) * Quad(range.upper) : Quad(range.upper);
  return !(exact < lower) && !(upper < exact);
}

/// All quantities that the case's field answers, of its component 0.
inline std::vector<RangeQuestion> QuestionsOf(const RangeCase& one)
{
  std::vector<RangeQuestion> questions;
  for (const Quantity quantity : { Quantity::Component, Quantity::Magnitude,
         Quantity::GradientComponent, Quantity::GradientMagnitude, Quantity::Jacobian })
  {
    const RangeQuestion question{ quantity, &one.field, 0, 1 };
    if (IsAnswerable(question))
    {
      questions.push_back(question);
    }
  }
  return questions;
}
} // namespace pixelexact::testing
