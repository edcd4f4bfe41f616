// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Bernstein/SweepKernels.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
/// Bernstein sum at eta by its definition, in long double.
long double At(
  const std::array<int, 3>& degree, const std::vector<double>& bernstein, const LongVec3& eta)
{
  const auto basis = [](int n, int i, long double z)
  {
    long double b = 1.0L;
    for (int k = 1; k <= i; ++k)
    {
      b = b * (n - i + k) / k;
    }
    return b * std::pow((1 + z) / 2, i) * std::pow((1 - z) / 2, n - i);
  };
  long double sum = 0.0L;
  std::size_t at = 0;
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int k = 0; k <= degree[2]; ++k)
      {
        sum += bernstein[at++] * basis(degree[0], i, eta[0]) * basis(degree[1], j, eta[1]) *
          basis(degree[2], k, eta[2]);
      }
    }
  }
  return sum;
}
} // namespace

TEST(BernsteinForm, SameFunctionAndHull)
{
  Random random(21);
  for (const Space& space : MakeSpaces({ 1, 2, 3, 5, 8 }))
  {
    std::vector<double> modes(space.Modes());
    std::vector<long double> values(space.Modes());
    for (double& c : modes)
    {
      c = random();
    }
    const auto& form = BernsteinForm::Of(space);
    std::vector<double> bernstein(form.Size());
    form.Convert(modes.data(), bernstein);
    const double bound = form.ErrorBound(modes.data());
    EXPECT_GT(bound, 0.0);
    const Hull hull = HullOf(bernstein);
    for (int trial = 0; trial < 30; ++trial)
    {
      const Vec3 eta(random(), random(), random());
      EvaluateModes(space, ToLong(TensorToReference(space.shape, eta)), values.data());
      long double expected = 0.0L;
      long double scale = 0.0L;
      for (std::size_t k = 0; k < modes.size(); ++k)
      {
        expected += modes[k] * values[k];
        scale += std::fabs(modes[k] * values[k]);
      }
      // The bound, plus the rounding of xi, to which the reference is evaluated.
      const double tolerance = bound + 1e-14 * static_cast<double>(scale);
      EXPECT_NEAR(
        static_cast<double>(At(form.Degree(), bernstein, ToLong(eta)) - expected), 0.0, tolerance);
      EXPECT_GE(static_cast<double>(expected), hull.lower - tolerance);
      EXPECT_LE(static_cast<double>(expected), hull.upper + tolerance);
    }
  }
}

TEST(BernsteinForm, ChildrenAreTheSameFunction)
{
  Random random(22);
  for (const Space& space : MakeSpaces({ 1, 2, 3, 5, 8 }))
  {
    std::vector<double> modes(space.Modes());
    for (double& c : modes)
    {
      c = random();
    }
    const auto& form = BernsteinForm::Of(space);
    std::vector<double> whole(form.Size());
    form.Convert(modes.data(), whole);
    double largest = 0.0;
    for (const double b : whole)
    {
      largest = std::max(largest, std::fabs(b));
    }
    for (int direction = 0; direction < 3; ++direction)
    {
      std::vector<double> lower = whole;
      std::vector<double> upper(whole.size());
      Subdivide(form.Degree(), direction, lower, upper);
      for (int trial = 0; trial < 5; ++trial)
      {
        const LongVec3 local{ random(), random(), random() };
        LongVec3 inLower = local;
        LongVec3 inUpper = local;
        inLower[direction] = (local[direction] - 1) / 2;
        inUpper[direction] = (local[direction] + 1) / 2;
        const auto difference = [&](const std::vector<double>& half, const LongVec3& at) {
          return static_cast<double>(At(form.Degree(), half, local) - At(form.Degree(), whole, at));
        };
        EXPECT_NEAR(difference(lower, inLower), 0.0, 1e-15 * largest);
        EXPECT_NEAR(difference(upper, inUpper), 0.0, 1e-15 * largest);
      }
    }
  }
}

TEST(BernsteinForm, ReferenceCoordinatesAreTheirGridValues)
{
  for (const Space& space : MakeSpaces({ 1, 2, 3, 5, 8 }))
  {
    const auto& form = BernsteinForm::Of(space);
    for (int d = 0; d < 3; ++d)
    {
      const auto change = ChangeOfBasis::FromFunctions(
        space, 1, [d](const LongVec3& xi, long double* value) { *value = xi[d]; });
      std::vector<double> modes(space.Modes());
      change.Apply(std::vector<double>{ 1.0 }, 0.0, modes);
      std::vector<double> bernstein(form.Size());
      form.Convert(modes.data(), bernstein);
      std::size_t at = 0;
      for (int i = 0; i <= form.Degree()[0]; ++i)
      {
        for (int j = 0; j <= form.Degree()[1]; ++j)
        {
          for (int k = 0; k <= form.Degree()[2]; ++k)
          {
            const Vec3 xi = TensorToReference(space.shape, form.GridPoint(i, j, k));
            EXPECT_NEAR(bernstein[at++], xi[d], 1e-13) << Name(space.shape) << " " << d;
          }
        }
      }
    }
  }
}
} // namespace pixelexact::testing
