// SPDX-License-Identifier: BSD-3-Clause
// What is said of an element's map before any point is looked for holds where it is evaluated.
#include "MeshBuilder.h"

#include "Core/Bounds/ElementBounds.h"
#include "Core/Element/LaneBuffer.h"

#include <gtest/gtest.h>

#include <array>

namespace pixelexact::testing
{
namespace
{
/// The identity and noise in all modes.
MeshBuilder NoisyElement(const Space& space, double noise, Random& random)
{
  MeshBuilder builder;
  builder.Add(space, [](const LongVec3& xi) { return xi; });
  for (double& coefficient : builder.Phi.Coefficients)
  {
    coefficient += noise * random();
  }
  return builder;
}

/// The three derivatives of each coordinate of Phi.
std::vector<std::array<double, 9>> JacobiansAt(
  const InverseProblem& problem, const std::vector<Vec3>& xi)
{
  const LaneBuffer at(xi);
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  std::vector<double> lanes(12 * stride);
  std::array<double*, 12> arrays{};
  for (std::size_t k = 0; k < 12; ++k)
  {
    arrays[k] = &lanes[k * stride];
  }
  KernelsFor(problem.space)
    .gradient(problem.space, problem.coefficients, 3, at.View(), arrays.data(), arrays.data() + 3);
  std::vector<std::array<double, 9>> jacobians(xi.size());
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    for (std::size_t k = 0; k < 9; ++k)
    {
      jacobians[i][k] = arrays[3 + k][i];
    }
  }
  return jacobians;
}

double MaxAbs(const Vec3& x)
{
  return std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
}

struct ShapeForm
{
  Shape shape;
  Form form;
};

class ElementBoundsOf : public ::testing::TestWithParam<ShapeForm>
{
};

TEST_P(ElementBoundsOf, NoJacobianChangesFasterThanTheBend)
{
  const auto [shape, form] = GetParam();
  Random random(71);
  for (const int order : { 1, 2, 3, 4, 6 })
  {
    Space space = UniformSpace(shape, order);
    space.form = form;
    const MeshBuilder builder = NoisyElement(space, 0.1, random);
    const Mesh mesh = builder.View();
    const ElementBounds bounds = MakeElementBounds(mesh, 0);
    const InverseProblem problem = MakeInverseProblem(mesh, 0, bounds);
    ASSERT_TRUE(std::isfinite(problem.bend)) << order;
    // Pairs of neighbours, half of them by a vertex, an edge or a face.
    constexpr std::size_t kPairs = 2000;
    std::vector<Vec3> xi;
    while (xi.size() < 2 * kPairs)
    {
      Vec3 eta(random(), random(), random(-1.0, 0.999));
      for (int d = 0; d < 2 && xi.size() % 4 == 0; ++d)
      {
        eta[d] = random() < 0.0 ? eta[d] : std::copysign(1.0, eta[d]);
      }
      const Vec3 a = TensorToReference(shape, eta);
      const double reach = 1e-3 * (shape == Shape::Pyramid ? 0.5 * (1.0 - a.z) : 1.0);
      const Vec3 b = a + reach * Vec3(random(), random(), random());
      xi.push_back(a);
      xi.push_back(b);
    }
    const auto jacobians = JacobiansAt(problem, xi);
    double most = 0.0;
    for (std::size_t i = 0; i < xi.size(); i += 2)
    {
      const double height = 0.5 * (1.0 - std::max(xi[i].z, xi[i + 1].z));
      const double unit = shape != Shape::Pyramid ? 1.0
        : form == Form::Tensor                    ? height * height
                                                  : height;
      for (std::size_t c = 0; c < 3; ++c)
      {
        double change = 0.0;
        for (std::size_t d = 0; d < 3; ++d)
        {
          change += std::fabs(jacobians[i + 1][3 * c + d] - jacobians[i][3 * c + d]);
        }
        most = std::max(most, change / MaxAbs(xi[i + 1] - xi[i]) * unit);
      }
    }
    EXPECT_LE(most, problem.bend * (1.0 + 1e-9)) << order;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ElementBoundsOf,
  ::testing::Values(ShapeForm{ Shape::Hexahedron, Form::Collapsed },
    ShapeForm{ Shape::Prism, Form::Collapsed }, ShapeForm{ Shape::Tetrahedron, Form::Collapsed },
    ShapeForm{ Shape::Pyramid, Form::Collapsed }, ShapeForm{ Shape::Pyramid, Form::Tensor }));
} // namespace
} // namespace pixelexact::testing
