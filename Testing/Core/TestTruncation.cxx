// SPDX-License-Identifier: BSD-3-Clause
// Fields whose top modes are dropped: what is left, that it is orthogonal to what went, and that
// the bound of the change holds.
#include "MeshBuilder.h"

#include "Core/Basis/LineFunctions.h"
#include "Core/Element/Truncation.h"
#include "Core/Location/Sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pixelexact::testing
{
namespace
{
/// One curved element and a field with random coefficients.
struct CurvedElement
{
  CurvedElement(const Space& space, int components, std::uint64_t seed)
    : Values(components)
  {
    Elements.Add(UniformSpace(space.shape, 3), Curved);
    Random random(seed);
    Values.Add(
      space, [&](const LongVec3& /*xi*/, long double* u) { std::fill_n(u, components, 0.0L); });
    for (double& coefficient : Values.Coefficients)
    {
      coefficient = random();
    }
    field_ = { "u", Values.View() };
  }

  MeshBuilder Elements;
  ExpansionBuilder Values;
  Field field_;
};

std::vector<double> EvaluateField(const Mesh& mesh, const Field& field, const std::vector<Vec3>& xi)
{
  std::vector<double> values(xi.size() * static_cast<std::size_t>(field.values.components));
  EvaluateAt(mesh, field, 0, xi, values, {});
  return values;
}

std::vector<Space> SpacesToTry()
{
  std::vector<Space> spaces;
  for (const Shape shape : kShapes)
  {
    spaces.push_back(UniformSpace(shape, 5));
  }
  spaces.push_back({ Shape::Hexahedron, Form::Collapsed, { 2, 6, 4 } });
  spaces.push_back({ Shape::Prism, Form::Collapsed, { 3, 5, 4 } });
  spaces.push_back({ Shape::Tetrahedron, Form::Collapsed, { 2, 4, 5 } });
  spaces.push_back({ Shape::Pyramid, Form::Tensor, { 4, 4, 4 } });
  return spaces;
}
} // namespace

TEST(Truncation, KeptAndDroppedAddUpAndTheBoundHolds)
{
  for (const Space& space : SpacesToTry())
  {
    for (int order = 0; order <= 6; ++order)
    {
      for (const int components : { 1, 3 })
      {
        const CurvedElement with(space, components, 7);
        const Mesh mesh = with.Elements.View();
        const Truncation truncation(with.field_, order);
        const Field kept = truncation.Kept();
        const Field dropped = truncation.Dropped();
        ASSERT_NO_THROW(Validate(kept, mesh));
        ASSERT_NO_THROW(Validate(dropped, mesh));
        EXPECT_LE(kept.values.SpaceOf(0).MaxOrder(), order);
        EXPECT_EQ(truncation.Modes(), space.Modes());
        EXPECT_EQ(truncation.DroppedModes(), space.Modes() - kept.values.SpaceOf(0).Modes());
        EXPECT_EQ(order >= space.MaxOrder(), truncation.DroppedModes() == 0);
        Random random(11);
        std::vector<Vec3> xi(200);
        std::ranges::generate(xi, [&] { return random.Inside(space.shape); });
        const std::vector<double> all = EvaluateField(mesh, with.field_, xi);
        const std::vector<double> low = EvaluateField(mesh, kept, xi);
        const std::vector<double> high = EvaluateField(mesh, dropped, xi);
        const double bound = LargestChange(mesh, truncation, 0);
        const double ofNorm = LargestChange(mesh, truncation, -1);
        double largest = 0.0;
        for (std::size_t k = 0; k < xi.size(); ++k)
        {
          double square = 0.0;
          for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
          {
            const std::size_t i = k * static_cast<std::size_t>(components) + c;
            ASSERT_NEAR(all[i], low[i] + high[i], 1e-10);
            square += high[i] * high[i];
          }
          ASSERT_LE(std::fabs(high[k * static_cast<std::size_t>(components)]), bound);
          ASSERT_LE(std::sqrt(square), ofNorm * (1.0 + 1e-14));
          largest = std::max(largest, std::fabs(high[k * static_cast<std::size_t>(components)]));
        }
        if (truncation.DroppedModes() == 0)
        {
          EXPECT_EQ(bound, 0.0);
          EXPECT_EQ(all, low);
        }
        else
        {
          // The bound is tight: somewhere values come near it.
          EXPECT_LT(bound, 30.0 * largest);
        }
      }
    }
  }
}

TEST(Truncation, WhatIsKeptIsTheBestOfItsOrder)
{
  // By quadrature on the reference shape: the dropped part is orthogonal to all kept modes.
  for (const Shape shape : kShapes)
  {
    const Space space = UniformSpace(shape, 4);
    const CurvedElement with(space, 1, 3);
    const Mesh mesh = with.Elements.View();
    const Truncation truncation(with.field_, 2);
    const auto points = GaussPoints(8);
    const LineFunctions lines = Lagrange(points);
    // Weights of Gauss's rule by Lagrange's polynomials, integrated with a rule of enough points.
    std::vector<double> weights(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const long double x = points[i];
      // w = 2 / ((1 - x^2) P'(x)^2), by Bonnet's recurrence.
      long double before = 1.0L;
      long double here = x;
      for (int n = 2; n <= 8; ++n)
      {
        const long double next = ((2 * n - 1) * x * here - (n - 1) * before) / n;
        before = here;
        here = next;
      }
      const long double slope = 8.0L * (before - x * here) / (1.0L - x * x);
      weights[i] = static_cast<double>(2.0L / ((1.0L - x * x) * slope * slope));
    }
    std::vector<Vec3> xi;
    std::vector<double> weight;
    for (std::size_t i = 0; i < 8; ++i)
    {
      for (std::size_t j = 0; j < 8; ++j)
      {
        for (std::size_t k = 0; k < 8; ++k)
        {
          const Vec3 eta(static_cast<double>(points[i]), static_cast<double>(points[j]),
            static_cast<double>(points[k]));
          const double h2 = (1.0 - eta.y) / 2.0;
          const double h3 = (1.0 - eta.z) / 2.0;
          const double jacobian = shape == Shape::Hexahedron ? 1.0
            : shape == Shape::Prism                          ? h3
            : shape == Shape::Tetrahedron                    ? h2 * h3 * h3
                                                             : h3 * h3;
          xi.push_back(TensorToReference(shape, eta));
          weight.push_back(weights[i] * weights[j] * weights[k] * jacobian);
        }
      }
    }
    const std::vector<double> dropped = EvaluateField(mesh, truncation.Dropped(), xi);
    Field kept = truncation.Kept();
    std::vector<double> mode(kept.values.coefficients.size());
    for (std::size_t m = 0; m < mode.size(); ++m)
    {
      std::ranges::fill(mode, 0.0);
      mode[m] = 1.0;
      kept.values.coefficients = mode;
      const std::vector<double> of = EvaluateField(mesh, kept, xi);
      double product = 0.0;
      for (std::size_t k = 0; k < xi.size(); ++k)
      {
        product += weight[k] * dropped[k] * of[k];
      }
      ASSERT_NEAR(product, 0.0, 1e-12) << Name(shape) << " mode " << m;
    }
  }
}

TEST(Truncation, NotANumberStaysWhereItIs)
{
  CurvedElement with(UniformSpace(Shape::Hexahedron, 3), 1, 5);
  with.Values.Coefficients.back() = std::nan("");
  const Truncation truncation({ "u", with.Values.View() }, 2);
  EXPECT_TRUE(std::isnan(truncation.Dropped().values.coefficients.back()));
  for (const double coefficient : truncation.Kept().values.coefficients)
  {
    EXPECT_TRUE(std::isfinite(coefficient));
  }
}
} // namespace pixelexact::testing
