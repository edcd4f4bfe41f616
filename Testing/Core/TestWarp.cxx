// SPDX-License-Identifier: BSD-3-Clause
// Deformed maps against long double sums of map and displacement; the scales at which elements
// invert against closed forms and against bisection with dense samples in long double.
#include "LongDual.h"
#include "LongMap.h"

#include "Core/Base/Error.h"
#include "Core/Element/Warp.h"
#include "Core/Element/WarpLimit.h"
#include "Core/Location/Sample.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pixelexact::testing
{
namespace
{
/// A mesh of one element or of several, with a displacement.
struct WarpCase
{
  MeshBuilder builder;
  ExpansionBuilder values{ 3 };

  [[nodiscard]] Field Displacement() const { return { "u", values.View() }; }
};

std::vector<WarpTerm> TermsOf(const Field& field)
{
  return { { &field, 0, Vec3(1, 0, 0) }, { &field, 1, Vec3(0, 1, 0) },
    { &field, 2, Vec3(0, 0, 1) } };
}

/// Adds an element with random modes, which decay.
void AddRandom(ExpansionBuilder& values, const Space& space, Random& random)
{
  values.SpaceOf.push_back(static_cast<std::int32_t>(values.Spaces.size()));
  values.Spaces.push_back(space);
  values.Offset.push_back(static_cast<std::int64_t>(values.Coefficients.size()));
  const std::vector<double> modes = RandomModes(space, random, 3, 0.6);
  values.Coefficients.insert(values.Coefficients.end(), modes.begin(), modes.end());
}

/// The field's value of stored coefficients in long double.
LongVec3 ValueOf(const Field& field, int element, const LongVec3& xi)
{
  LongModes<long double> evaluate;
  const std::vector<long double>& modes = evaluate(field.values.SpaceOf(element), xi);
  const double* coefficient = field.values.Coefficients(element);
  LongVec3 value{};
  for (int d = 0; d < 3; ++d)
  {
    for (const long double mode : modes)
    {
      value[d] += *coefficient++ * mode;
    }
  }
  return value;
}

TEST(Warp, TheMapIsTheSumOfMapAndDisplacement)
{
  Random random(7);
  for (const int geometry : { 1, 3, 8 })
  {
    for (int order = 2; order <= 8; ++order)
    {
      WarpCase one;
      std::vector<Space> fields;
      for (const Space& space : MakeSpaces({ geometry }))
      {
        if (space.form == Form::Collapsed)
        {
          AddRandom(one.builder.Phi, space, random);
          one.builder.Centre.insert(one.builder.Centre.end(), { 3.0, -7.0, 0.5 });
          one.builder.Size.push_back(0.25);
          one.builder.Uncertainty.push_back(1e-17);
          const Form form =
            space.shape == Shape::Pyramid && random() > 0.0 ? Form::Tensor : Form::Collapsed;
          const auto n = static_cast<std::uint8_t>(order);
          AddRandom(one.values, { space.shape, form, { n, n, n } }, random);
        }
      }
      const Field u = one.Displacement();
      const Mesh mesh = one.builder.View();
      for (const double scale : { 0.0, 1.0, -0.37, 1e3 })
      {
        const OwnedMesh warped = WarpedMesh(mesh, TermsOf(u), scale, 0.0);
        const Mesh deformed = warped.View();
        Validate(deformed);
        LongMap before(mesh);
        LongMap after(deformed);
        for (int e = 0; e < mesh.Elements(); ++e)
        {
          for (int k = 0; k < 4; ++k)
          {
            const LongVec3 xi = ToLong(random.Inside(mesh.ShapeOf(e)));
            const LongVec3 x = before(e, xi);
            const LongVec3 moved = ValueOf(u, e, xi);
            const LongVec3 found = after(e, xi);
            for (int d = 0; d < 3; ++d)
            {
              const long double expected = x[d] + scale * moved[d];
              ASSERT_NEAR(static_cast<double>(found[d]), static_cast<double>(expected),
                deformed.uncertainty[static_cast<std::size_t>(e)])
                << Name(mesh.ShapeOf(e)) << " " << geometry << " " << order << " " << scale;
            }
          }
          // The bound is some roundings of the sizes in it, not more.
          ASSERT_LT(deformed.uncertainty[static_cast<std::size_t>(e)],
            1e-12 * (1.0 + std::fabs(scale)) * (1 + order));
        }
      }
    }
  }
}

TEST(Warp, AScaleOfZeroKeepsTheCoefficients)
{
  WarpCase one;
  const Space space = UniformSpace(Shape::Tetrahedron, 3);
  one.builder.Add(space, Curved, Vec3(0.1, 0.2, 0.3), 2.0);
  one.values.Add(UniformSpace(Shape::Tetrahedron, 2),
    [](const LongVec3& xi, long double* v) { v[0] = xi[0] * xi[1], v[1] = 1.0L, v[2] = xi[2]; });
  const Field u = one.Displacement();
  const OwnedMesh warped = WarpedMesh(one.builder.View(), TermsOf(u), 0.0, 0.0);
  EXPECT_TRUE(std::ranges::equal(warped.map.coefficients, one.builder.Phi.Coefficients));
  EXPECT_EQ(warped.centre, one.builder.Centre);
  EXPECT_EQ(warped.size, one.builder.Size);
}

TEST(Warp, ScalarsMoveAlongADirection)
{
  WarpCase one;
  one.builder.Add(UniformSpace(Shape::Hexahedron, 2), [](const LongVec3& xi) { return xi; });
  ExpansionBuilder values(1);
  values.Add(UniformSpace(Shape::Hexahedron, 4),
    [](const LongVec3& xi, long double* v) { v[0] = xi[0] * xi[0] * xi[1] * xi[1]; });
  const Field p{ "p", values.View() };
  const std::array<WarpTerm, 1> terms{ WarpTerm{ &p, 0, Vec3(1.0, 0.0, -2.0) } };
  const OwnedMesh warped = WarpedMesh(one.builder.View(), terms, 0.5, 0.0);
  const std::vector<Vec3> xi{ Vec3(0.3, -0.6, 0.9) };
  std::vector<Vec3> x(1);
  MapForward(warped.View(), 0, xi, x);
  const double moved = 0.5 * 0.09 * 0.36;
  EXPECT_NEAR(x[0].x, 0.3 + moved, 1e-15);
  EXPECT_NEAR(x[0].y, -0.6, 1e-15);
  EXPECT_NEAR(x[0].z, 0.9 - 2.0 * moved, 1e-15);
}

TEST(Warp, WhatIsNotFiniteIsNamed)
{
  WarpCase one;
  one.builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  one.values.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi, long double* v) { v[0] = xi[0], v[1] = v[2] = 0.0L; });
  const Field u = one.Displacement();
  const auto errorOf = [&](double scale)
  {
    try
    {
      (void)WarpedMesh(one.builder.View(), TermsOf(u), scale, 0.0);
    }
    catch (const InvalidData& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(errorOf(1e305).find("element 0 of the deformed mesh is too large"), std::string::npos)
    << errorOf(1e305);
  one.values.Coefficients[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(errorOf(1.0).find("the displacement 'u' is not finite in element 0"), std::string::npos)
    << errorOf(1.0);
}

using LongMatrix = std::array<std::array<long double, 3>, 3>;

/// The derivatives by xi of the function of element 0, in long double.
LongMatrix SlopesAt(const Expansion& expansion, long double factor, const Vec3& at)
{
  using Dual = LongDual<long double>;
  std::array<Dual, 3> xi;
  for (int d = 0; d < 3; ++d)
  {
    xi[static_cast<std::size_t>(d)] = Dual::Variable(at[d], d);
  }
  LongModes<Dual> evaluate;
  const std::vector<Dual>& modes = evaluate(expansion.SpaceOf(0), xi);
  const double* coefficient = expansion.Coefficients(0);
  LongMatrix slopes{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (const Dual& mode : modes)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        slopes[i][j] += factor * *coefficient * mode.derivative[j];
      }
      ++coefficient;
    }
  }
  return slopes;
}

/// det J of x + s u at a point, as a function of s.
class DeterminantAt
{
public:
  DeterminantAt(const Mesh& mesh, const Field& u, const Vec3& xi)
    : Map(SlopesAt(mesh.map, mesh.size[0], xi))
    , Displacement(SlopesAt(u.values, 1.0L, xi))
  {
  }

  long double operator()(long double s) const
  {
    LongMatrix J = Map;
    for (std::size_t i = 0; i < 9; ++i)
    {
      J[i / 3][i % 3] += s * Displacement[i / 3][i % 3];
    }
    return J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1]) -
      J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0]) +
      J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0]);
  }

private:
  LongMatrix Map;
  LongMatrix Displacement;
};

/// The least s > 0 at which det J is not positive at one of the samples: each sample's first root
/// by steps and bisection.
long double FirstInversion(const Mesh& mesh, const Field& u, int samples, long double most)
{
  long double first = most;
  for (int i = 0; i < samples * samples * samples; ++i)
  {
    const auto at = [&](int k) { return -1.0 + 2.0 * k / (samples - 1); };
    // LongModes has no derivatives at a pyramid's apex.
    const double apex = mesh.ShapeOf(0) == Shape::Pyramid ? 0.999 : 1.0;
    const DeterminantAt determinant(mesh, u,
      TensorToReference(mesh.ShapeOf(0),
        { at(i % samples), at(i / samples % samples), std::min(at(i / samples / samples), apex) }));
    constexpr int kSteps = 64;
    for (int k = 1; k <= kSteps; ++k)
    {
      if (determinant(first * k / kSteps) > 0.0L)
      {
        continue;
      }
      long double low = first * (k - 1) / kSteps;
      long double high = first * k / kSteps;
      for (int bisection = 0; bisection < 60; ++bisection)
      {
        const long double middle = 0.5L * (low + high);
        (determinant(middle) > 0.0L ? low : high) = middle;
      }
      first = high;
      break;
    }
  }
  return first;
}

/// Checks the limits of one element: in order, near to each other, proven by the sign of det J in
/// long double at the point given, and not contradicted by samples.
void CheckLimit(const WarpCase& one, int samples, const std::string& name)
{
  const Mesh mesh = one.builder.View();
  const Field u = one.Displacement();
  const WarpLimit limit = FindWarpLimit(mesh, TermsOf(u));
  ASSERT_TRUE(limit.leftOut.empty()) << name;
  ASSERT_TRUE(limit.met) << name;
  ASSERT_TRUE(std::isfinite(limit.inverted)) << name;
  EXPECT_GT(limit.positive, 0.0) << name;
  EXPECT_LT(limit.positive, limit.inverted) << name;
  EXPECT_NEAR(limit.positive, limit.inverted, 1e-6 * limit.inverted) << name;
  EXPECT_EQ(limit.element, 0) << name;
  const DeterminantAt determinant(mesh, u, limit.xi);
  EXPECT_LE(determinant(limit.inverted), 1e-12L * determinant(0.0L)) << name;
  const auto sampled = static_cast<double>(FirstInversion(mesh, u, samples, 2.0L * limit.inverted));
  EXPECT_GE(sampled, limit.positive) << name;
  // Samples come within the square of their distance, times the curvature.
  EXPECT_NEAR(sampled, limit.inverted, 2e-2 * limit.inverted) << name;
}

TEST(WarpLimit, TenElementsAgainstDenseSamples)
{
  Random random(11);
  struct Kind
  {
    Shape shape;
    int geometry;
    int order;
  };
  for (const auto& [shape, geometry, order] : { Kind{ Shape::Hexahedron, 3, 2 },
         Kind{ Shape::Hexahedron, 3, 4 }, Kind{ Shape::Hexahedron, 3, 7 },
         Kind{ Shape::Prism, 3, 2 }, Kind{ Shape::Prism, 3, 5 }, Kind{ Shape::Tetrahedron, 3, 3 },
         Kind{ Shape::Tetrahedron, 3, 6 }, Kind{ Shape::Tetrahedron, 3, 8 },
         Kind{ Shape::Pyramid, 3, 2 }, Kind{ Shape::Pyramid, 3, 4 } })
  {
    WarpCase one;
    one.builder.Add(UniformSpace(shape, geometry), Curved, Vec3(0.0), 2.0);
    AddRandom(one.values, UniformSpace(shape, order), random);
    CheckLimit(one, 25, std::string(Name(shape)) + " " + std::to_string(order));
  }
}

TEST(WarpLimit, ClosedForms)
{
  // x - s x1^2 / 2 e1 on [-1,1]: det J = 1 - s xi1, zero first at s = 1, at xi1 = 1.
  WarpCase one;
  one.builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  one.values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi, long double* v) { v[0] = -0.5L * xi[0] * xi[0], v[1] = v[2] = 0.0L; });
  const Field u = one.Displacement();
  WarpLimit limit = FindWarpLimit(one.builder.View(), TermsOf(u));
  EXPECT_LE(limit.positive, 1.0);
  EXPECT_GE(limit.inverted, 1.0);
  EXPECT_NEAR(limit.positive, 1.0, 1e-6);
  EXPECT_NEAR(limit.inverted, 1.0, 1e-6);
  EXPECT_NEAR(limit.xi.x, 1.0, 1e-5);
  // The least value inside: det J = 1 - s (1 - (xi1 - 0.3)^2), zero first at s = 1, at xi1 = 0.3.
  WarpCase inner;
  inner.builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  inner.values.Add(UniformSpace(Shape::Hexahedron, 3),
    [](const LongVec3& xi, long double* v)
    {
      const long double t = xi[0] - 0.3L;
      v[0] = t * t * t / 3.0L - xi[0];
      v[1] = v[2] = 0.0L;
    });
  const Field w = inner.Displacement();
  limit = FindWarpLimit(inner.builder.View(), TermsOf(w));
  EXPECT_LE(limit.positive, 1.0);
  EXPECT_NEAR(limit.positive, 1.0, 1e-6);
  EXPECT_GE(limit.inverted, 1.0 - 1e-12);
  EXPECT_NEAR(limit.inverted, 1.0, 1e-6);
  EXPECT_NEAR(limit.xi.x, 0.3, 2e-3);
}

TEST(WarpLimit, ElementsThatDoNotMoveHaveNoLimit)
{
  WarpCase two;
  two.builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  two.builder.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi) {
      return LongVec3{ xi[0] + 2.0L, xi[1], xi[2] };
    });
  two.values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& /*xi*/, long double* v) { v[0] = v[1] = v[2] = 0.0L; });
  two.values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi, long double* v) { v[0] = -0.5L * xi[0] * xi[0], v[1] = v[2] = 0.0L; });
  const Field u = two.Displacement();
  const WarpLimit limit = FindWarpLimit(two.builder.View(), TermsOf(u));
  EXPECT_TRUE(limit.leftOut.empty());
  EXPECT_TRUE(limit.met);
  EXPECT_EQ(limit.element, 1);
  EXPECT_LE(limit.positive, 1.0);
  EXPECT_NEAR(limit.positive, 1.0, 1e-6);
  EXPECT_NEAR(limit.inverted, 1.0, 1e-6);
}

TEST(WarpLimit, TurnsNothingInside)
{
  // A stretch, a shift: det J = 1 + s and 1.
  for (const bool stretch : { true, false })
  {
    WarpCase one;
    one.builder.Add(UniformSpace(Shape::Prism, 1), [](const LongVec3& xi) { return xi; });
    one.values.Add(UniformSpace(Shape::Prism, 1),
      [stretch](const LongVec3& xi, long double* v)
      { v[0] = stretch ? xi[0] : 5.0L, v[1] = v[2] = 0.0L; });
    const Field u = one.Displacement();
    const WarpLimit limit = FindWarpLimit(one.builder.View(), TermsOf(u));
    EXPECT_GE(limit.positive, 1e5);
    EXPECT_TRUE(std::isinf(limit.inverted));
    EXPECT_EQ(limit.element, -1);
    EXPECT_TRUE(limit.met);
  }
}

TEST(WarpLimit, ElementsThatAreNotValidAreLeftOut)
{
  WarpCase two;
  two.builder.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi) {
      return LongVec3{ -xi[0], xi[1], xi[2] };
    });
  two.builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  for (int e = 0; e < 2; ++e)
  {
    two.values.Add(UniformSpace(Shape::Hexahedron, 1),
      [](const LongVec3& xi, long double* v) { v[0] = -xi[0] / 4.0L, v[1] = v[2] = 0.0L; });
  }
  const Field u = two.Displacement();
  const WarpLimit limit = FindWarpLimit(two.builder.View(), TermsOf(u));
  EXPECT_EQ(limit.leftOut, std::vector<int>{ 0 });
  EXPECT_EQ(limit.element, 1);
  EXPECT_NEAR(limit.positive, 4.0, 4e-6);
}

TEST(WarpLimit, IsTheSameOnOneThread)
{
  Random random(5);
  WarpCase several;
  for (int e = 0; e < 12; ++e)
  {
    const Shape shape = kShapes[static_cast<std::size_t>(e) % 3];
    several.builder.Add(UniformSpace(shape, 3), Curved, Vec3(0.0), 2.0);
    AddRandom(several.values, UniformSpace(shape, 3), random);
  }
  const Field u = several.Displacement();
  const WarpLimit all = FindWarpLimit(several.builder.View(), TermsOf(u));
  const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
  const WarpLimit one = FindWarpLimit(several.builder.View(), TermsOf(u));
  EXPECT_EQ(all.positive, one.positive);
  EXPECT_EQ(all.inverted, one.inverted);
  EXPECT_EQ(all.element, one.element);
  EXPECT_EQ(all.boxes, one.boxes);
}

TEST(WarpLimit, OrdersThatAreTooHighAreRefused)
{
  WarpCase one;
  one.builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  Random random(1);
  AddRandom(one.values, UniformSpace(Shape::Hexahedron, 22), random);
  const Field u = one.Displacement();
  EXPECT_THROW((void)FindWarpLimit(one.builder.View(), TermsOf(u)), Unsupported);
}
} // namespace
} // namespace pixelexact::testing
