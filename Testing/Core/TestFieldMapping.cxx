// SPDX-License-Identifier: BSD-3-Clause
#include "InstructionSets.h"
#include "MeshBuilder.h"

#include "Core/Element/FieldMapping.h"
#include "Core/Location/Sample.h"

#include <gtest/gtest.h>

#include <algorithm>

// Closed forms: reference functions made, by hand, so that the mapped field is u = (y, z + x, x -
// y) or the density z - 2 x on a map of degree 2.
namespace pixelexact::testing
{
namespace
{
constexpr double kSize = 0.25;
const Vec3 kCentre(5.0, -3.0, 2.0);

LongVec3 Bent(const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  return { 5 + 0.25L * (a + 0.1L * b * b), -3 + 0.25L * (b + 0.08L * a * c),
    2 + 0.25L * (c + 0.06L * a * b) };
}

/// Rows: dx_i / dxi.
std::array<LongVec3, 3> Jacobian(const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  return { LongVec3{ 0.25L, 0.25L * 0.2L * b, 0 },
    LongVec3{ 0.25L * 0.08L * c, 0.25L, 0.25L * 0.08L * a },
    LongVec3{ 0.25L * 0.06L * b, 0.25L * 0.06L * a, 0.25L } };
}

LongVec3 U(const LongVec3& x)
{
  return { x[1], x[2] + x[0], x[0] - x[1] };
}
constexpr double kGradientOfU[9] = { 0, 1, 0, 1, 0, 1, 1, -1, 0 };

long double Density(const LongVec3& x)
{
  return x[2] - 2 * x[0];
}

long double Determinant(const std::array<LongVec3, 3>& J)
{
  const LongVec3 n = Cross(J[1], J[2]);
  return J[0][0] * n[0] + J[0][1] * n[1] + J[0][2] * n[2];
}

void PullBack(Mapping mapping, const LongVec3& xi, long double* values)
{
  const auto J = Jacobian(xi);
  const LongVec3 x = Bent(xi);
  const LongVec3 u = U(x);
  if (mapping == Mapping::Density)
  {
    values[0] = Density(x) * Determinant(J);
    return;
  }
  // The adjugate's columns are cross products of J's rows.
  const LongVec3 adjugate[3] = { Cross(J[1], J[2]), Cross(J[2], J[0]), Cross(J[0], J[1]) };
  for (int i = 0; i < 3; ++i)
  {
    values[i] = 0;
    for (int a = 0; a < 3; ++a)
    {
      values[i] += (mapping == Mapping::Covariant ? J[a][i] : adjugate[a][i]) * u[a];
    }
  }
}

class FieldMapping : public ::testing::TestWithParam<Shape>
{
protected:
  FieldMapping() { Builder.Add(UniformSpace(GetParam(), 2), Bent, kCentre, kSize); }

  void Check(Mapping mapping)
  {
    const int components = mapping == Mapping::Density ? 1 : 3;
    ExpansionBuilder values(components);
    values.Add(UniformSpace(GetParam(), mapping == Mapping::Density ? 5 : 4),
      [&](const LongVec3& xi, long double* out) { PullBack(mapping, xi, out); });
    const Field field{ "u", values.View(), mapping };
    Random random(11);
    for (int trial = 0; trial < 50; ++trial)
    {
      const Vec3 xi = random.Inside(GetParam());
      std::vector<double> value(components);
      std::vector<double> gradient(3 * components);
      EvaluateAt(Builder.View(), field, 0, std::span(&xi, 1), value, gradient);
      const LongVec3 x = Bent(ToLong(xi));
      if (mapping == Mapping::Density)
      {
        EXPECT_NEAR(value[0], static_cast<double>(Density(x)), 1e-13);
        EXPECT_NEAR(gradient[0], -2.0, 1e-12);
        EXPECT_NEAR(gradient[1], 0.0, 1e-12);
        EXPECT_NEAR(gradient[2], 1.0, 1e-12);
        continue;
      }
      const LongVec3 u = U(x);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(value[c], static_cast<double>(u[c]), 1e-13);
        for (int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(gradient[3 * c + d], kGradientOfU[3 * c + d], 1e-12);
        }
      }
    }
  }

  MeshBuilder Builder;
};
} // namespace

TEST_P(FieldMapping, CovariantGivesTheWorldField)
{
  Check(Mapping::Covariant);
}

TEST_P(FieldMapping, ContravariantGivesTheWorldField)
{
  Check(Mapping::Contravariant);
}

TEST_P(FieldMapping, DensityGivesTheWorldField)
{
  Check(Mapping::Density);
}

TEST_P(FieldMapping, ManyPointsLikeOneAlone)
{
  for (const Mapping mapping : { Mapping::Covariant, Mapping::Contravariant, Mapping::Density })
  {
    const int components = mapping == Mapping::Density ? 1 : 3;
    ExpansionBuilder values(components);
    values.Add(UniformSpace(GetParam(), mapping == Mapping::Density ? 5 : 4),
      [&](const LongVec3& xi, long double* out) { PullBack(mapping, xi, out); });
    const Field field{ "u", values.View(), mapping };
    Random random(5);
    std::vector<Vec3> xi(301);
    std::ranges::generate(xi, [&] { return random.Inside(GetParam()); });
    const auto width = static_cast<std::size_t>(components);
    OnEveryInstructionSet(
      [&]
      {
        std::vector<double> expected;
        for (const Vec3& one : xi)
        {
          std::vector<double> value(width);
          EvaluateAt(Builder.View(), field, 0, std::span(&one, 1), value, {});
          expected.insert(expected.end(), value.begin(), value.end());
        }
        std::vector<double> value(width * xi.size());
        EvaluateAt(Builder.View(), field, 0, xi, value, {});
        EXPECT_EQ(value, expected);
      });
  }
}

TEST_P(FieldMapping, SecondDerivativesOfThePolynomial)
{
  const Mesh mesh = Builder.View();
  Hessian H;
  SecondDerivatives(mesh.map.SpaceOf(0), mesh.map.Coefficients(0), Random(3).Inside(GetParam()), H);
  for (int c = 0; c < 3; ++c)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        const bool bb = c == 0 && j == 1 && k == 1;
        const bool ac = c == 1 && j != k && j != 1 && k != 1;
        const bool ab = c == 2 && j != k && j != 2 && k != 2;
        EXPECT_NEAR(H[c][j][k], bb ? 0.2 : ac ? 0.08 : ab ? 0.06 : 0.0, 1e-13);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, FieldMapping, ::testing::ValuesIn(kShapes),
  [](const auto& shape) { return Name(shape.param); });
} // namespace pixelexact::testing
