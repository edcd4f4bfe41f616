// SPDX-License-Identifier: BSD-3-Clause
// Values in single precision against those in double precision.
#include "InstructionSets.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/LaneBuffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace pixelexact::testing
{
namespace
{
struct Evaluated
{
  std::vector<double> exact;
  std::vector<double> floats;
};

Evaluated Evaluate(const Space& space, const std::vector<double>& coefficients, int components,
  const std::vector<Vec3>& xi)
{
  const LaneBuffer at(xi);
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  Evaluated result{ std::vector<double>(stride * static_cast<std::size_t>(components)), {} };
  result.floats = result.exact;
  std::vector<double*> exact;
  std::vector<double*> floats;
  for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
  {
    exact.push_back(&result.exact[c * stride]);
    floats.push_back(&result.floats[c * stride]);
  }
  KernelsFor(space).value(space, coefficients.data(), components, at.View(), exact.data());
  KernelsFor(space).valueInFloats(space, coefficients.data(), components, at.View(), floats.data());
  return result;
}

class FloatKernels : public ::testing::TestWithParam<Shape>
{
protected:
  std::vector<Vec3> Points(int count)
  {
    std::vector<Vec3> xi(static_cast<std::size_t>(count));
    for (Vec3& x : xi)
    {
      x = TensorToReference(GetParam(), { Uniform(Random), Uniform(Random), Uniform(Random) });
    }
    return xi;
  }

  void CheckErrors();

  std::mt19937 Random{ 7 };
  std::uniform_real_distribution<double> Uniform{ -1.0, 1.0 };
};
} // namespace

void FloatKernels::CheckErrors()
{
  for (const int order : { 1, 2, 3, 6, 8, 9, 14 })
  {
    const Space space = UniformSpace(GetParam(), order);
    const auto modes = static_cast<std::size_t>(space.Modes());
    std::vector<double> bounds;
    ForEachMode(space,
      [&](int p, int q, int r, int /*mode*/) { bounds.push_back(ModeBound(space, p, q, r)); });
    // Sizes that no float has; one component of each.
    const std::vector<double> sizes{ 1.0, 1e-300, 1e250 };
    std::vector<double> coefficients;
    std::vector<double> sums;
    for (const double size : sizes)
    {
      sums.push_back(0.0);
      for (std::size_t k = 0; k < modes; ++k)
      {
        coefficients.push_back(size * Uniform(Random) / bounds[k]);
        sums.back() += std::fabs(coefficients.back()) * bounds[k];
      }
    }
    // Counts that end within packs.
    for (const int count : { 1, 7, 8, 9, 16, 100 })
    {
      const auto result =
        Evaluate(space, coefficients, static_cast<int>(sizes.size()), Points(count));
      const std::size_t stride = result.exact.size() / sizes.size();
      for (std::size_t i = 0; i < result.exact.size(); ++i)
      {
        if (i % stride >= static_cast<std::size_t>(count))
        {
          continue; // padding
        }
        EXPECT_LE(
          std::fabs(result.floats[i] - result.exact[i]), (4 * order + 8) * 6e-8 * sums[i / stride])
          << Name(GetParam()) << " order " << order << " point " << i % stride;
      }
    }
  }
}

TEST_P(FloatKernels, ErrorsAreRoundoffsOfFloats)
{
  OnEveryInstructionSet([this] { CheckErrors(); });
}

TEST_P(FloatKernels, WhatIsNotFiniteIsNotMadeSo)
{
  constexpr std::size_t kPoints = 20;
  const Space space = UniformSpace(GetParam(), 3);
  const auto valuesOf = [&](const std::vector<double>& coefficients)
  {
    auto values = Evaluate(space, coefficients, 1, Points(kPoints)).floats;
    values.resize(kPoints); // without the padding, which narrow lanes leave alone
    return values;
  };
  OnEveryInstructionSet(
    [&]
    {
      std::vector<double> coefficients(static_cast<std::size_t>(space.Modes()), 1.0);
      coefficients[2] = std::numeric_limits<double>::quiet_NaN();
      for (const double value : valuesOf(coefficients))
      {
        EXPECT_TRUE(std::isnan(value));
      }
      coefficients.assign(coefficients.size(), 0.0);
      for (const double value : valuesOf(coefficients))
      {
        EXPECT_EQ(value, 0.0);
      }
    });
}

INSTANTIATE_TEST_SUITE_P(Shapes, FloatKernels,
  ::testing::Values(Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron, Shape::Pyramid));
} // namespace pixelexact::testing
