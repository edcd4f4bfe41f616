// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LongVectors.h"

#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Element/Mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <map>
#include <vector>

namespace pixelexact::testing
{
/// Owns the arrays of manufactured meshes and fields: polynomials given as functions of xi.
class ExpansionBuilder
{
public:
  using Function = std::function<void(const LongVec3& xi, long double* values)>;

  explicit ExpansionBuilder(int components)
    : Components(components)
  {
  }

  /// The function must lie in the space.
  void Add(const Space& space, const Function& function)
  {
    auto [entry, isNew] = SpaceIndex.try_emplace(space, static_cast<int>(Spaces.size()));
    if (isNew)
    {
      Spaces.push_back(space);
    }
    SpaceOf.push_back(entry->second);
    Offset.push_back(static_cast<std::int64_t>(Coefficients.size()));
    const auto change = ChangeOfBasis::FromFunctions(space, Components, function);
    std::vector<double> unit(Components, 0.0);
    std::vector<double> modes(space.Modes());
    for (int c = 0; c < Components; ++c)
    {
      unit[c] = 1.0;
      change.Apply(unit, 0.0, modes);
      unit[c] = 0.0;
      Coefficients.insert(Coefficients.end(), modes.begin(), modes.end());
    }
  }

  [[nodiscard]] Expansion View() const
  {
    return { Spaces, SpaceOf, Offset, Coefficients, Components };
  }

  std::vector<double> Coefficients;
  std::vector<Space> Spaces;
  std::vector<std::int32_t> SpaceOf;
  std::vector<std::int64_t> Offset;

private:
  int Components;
  std::map<Space, int> SpaceIndex;
};

class MeshBuilder
{
public:
  using Map = std::function<LongVec3(const LongVec3& xi)>;

  /// centre and size as a reader would choose them for a map of about this extent.
  void Add(const Space& space, const Map& map, const Vec3& centre = Vec3(0.0), double size = 1.0)
  {
    Phi.Add(space,
      [&](const LongVec3& xi, long double* values)
      {
        const LongVec3 x = map(xi);
        for (int d = 0; d < 3; ++d)
        {
          values[d] = (x[d] - centre[d]) / size;
        }
      });
    for (int d = 0; d < 3; ++d)
    {
      Centre.push_back(centre[d]);
    }
    Size.push_back(size);
    Uncertainty.push_back(0.0);
  }

  [[nodiscard]] Mesh View() const { return { Phi.View(), Centre, Size, Uncertainty }; }

  ExpansionBuilder Phi{ 3 };
  std::vector<double> Centre;
  std::vector<double> Size;
  std::vector<double> Uncertainty;
};

/// A reproducible stream of numbers in [low, high) (splitmix64; the same on every platform).
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }
  double operator()(double low = -1.0, double high = 1.0)
  {
    State += 0x9e3779b97f4a7c15U;
    std::uint64_t z = State;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return low + (high - low) * static_cast<double>(z >> 11U) * 0x1p-53;
  }
  /// A point of the shape, uniform in eta.
  Vec3 Inside(Shape shape)
  {
    const double a = (*this)();
    const double b = (*this)();
    const double c = (*this)();
    return TensorToReference(shape, { a, b, c });
  }

private:
  std::uint64_t State;
};

inline constexpr Shape kShapes[] = { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron,
  Shape::Pyramid };

/// Spaces of these orders on all shapes, and some whose orders differ by direction.
inline std::vector<Space> MakeSpaces(std::initializer_list<int> orders)
{
  std::vector<Space> spaces;
  for (const Shape shape : kShapes)
  {
    for (const int order : orders)
    {
      spaces.push_back(UniformSpace(shape, order));
    }
  }
  spaces.push_back({ Shape::Hexahedron, Form::Collapsed, { 1, 4, 2 } });
  spaces.push_back({ Shape::Prism, Form::Collapsed, { 2, 1, 4 } });
  spaces.push_back({ Shape::Tetrahedron, Form::Collapsed, { 1, 2, 4 } });
  spaces.push_back({ Shape::Pyramid, Form::Collapsed, { 2, 3, 4 } });
  spaces.push_back({ Shape::Pyramid, Form::Tensor, { 2, 2, 2 } });
  return spaces;
}

/// Random modes of each component, each `decay` as large as those of one degree less. A Tensor form
/// is closed at the apex exactly: multiples of 2^-40 have exact sums.
inline std::vector<double> RandomModes(
  const Space& space, Random& random, int components = 1, double decay = 1.0)
{
  std::vector<double> modes;
  for (int c = 0; c < components; ++c)
  {
    double sum = 0.0;
    ForEachMode(space,
      [&](int p, int q, int r, int)
      {
        modes.push_back(std::round(random() * std::pow(decay, p + q + r) * 0x1p40) * 0x1p-40);
        sum = (r == 0 ? 0.0 : sum) + modes.back();
        if (space.form == Form::Tensor && p + q > 0 && r == space.LastR(p, q))
        {
          modes.back() -= sum;
        }
      });
  }
  return modes;
}

/// A gently curved map of degree 3 in each coordinate, injective on every shape.
inline LongVec3 Curved(const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  return { a + 0.1L * b * b - 0.05L * c * a + 0.03L * b * b * c,
    b + 0.08L * a * c - 0.04L * a * a + 0.02L * c * c * c, c + 0.06L * a * b + 0.05L * a * a * b };
}
} // namespace pixelexact::testing
