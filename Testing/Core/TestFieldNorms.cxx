// SPDX-License-Identifier: BSD-3-Clause
// Norms over bent cubes against a Gauss rule in long double over the cube, and closed forms.
#include "CurvedMeshes.h"

#include "Core/Basis/LineFunctions.h"
#include "Core/Integral/FieldNorms.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// The cube in 8 blocks of these shapes, with a field u of the place.
class NormCase
{
public:
  template <class Function>
  NormCase(std::span<const Shape> shapes, int order, const Function& function)
    : mesh_(Placement{})
    , Values(1)
  {
    std::size_t k = 0;
    for (const double x : { -1.0, 0.0 })
    {
      for (const double y : { -1.0, 0.0 })
      {
        for (const double z : { -1.0, 0.0 })
        {
          mesh_.Fill({ { x, y, z }, 1.0 }, shapes[k++ % shapes.size()]);
        }
      }
    }
    const Mesh mesh = mesh_.View();
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      Values.Add(UniformSpace(mesh.ShapeOf(e), order),
        [&](const LongVec3& xi, long double* value) { *value = function(xi); });
    }
    field_.name = "u";
    field_.values = Values.View();
  }

  [[nodiscard]] FieldNorms Norms(const NormEffort& effort = {}) const
  {
    return FindNorms(mesh_.View(), field_, 0.0, effort);
  }
  [[nodiscard]] Mesh GetMesh() const { return mesh_.View(); }
  [[nodiscard]] const Field& GetField() const { return field_; }

private:
  CurvedMesh mesh_;
  ExpansionBuilder Values;
  Field field_;
};

/// The volume of the bent cube: the integral of det dBend / du, from differences of the polynomial
/// Bend that are exact for its degree, with 8 Gauss points a direction.
long double VolumeOfBend()
{
  std::vector<long double> points = GaussPoints(8);
  std::vector<long double> weights;
  for (const long double z : points)
  {
    // Christoffel's weights: 1 / sum of the squares of normalised Legendre polynomials.
    long double before = 1.0L;
    long double now = z;
    long double sum = 0.5L + 1.5L * z * z;
    for (int n = 2; n < 8; ++n)
    {
      const long double next = ((2 * n - 1) * z * now - (n - 1) * before) / n;
      before = now;
      now = next;
      sum += (n + 0.5L) * now * now;
    }
    weights.push_back(1.0L / sum);
  }
  // A polynomial of degree 3 along a line has this derivative at its middle.
  const auto derivative = [](LongVec3 u, int d)
  {
    const auto at = [&](long double step)
    {
      LongVec3 moved = u;
      moved[d] += step;
      return Bend(moved);
    };
    const LongVec3 far[] = { at(2.0L), at(-2.0L) };
    const LongVec3 near[] = { at(1.0L), at(-1.0L) };
    LongVec3 slope{};
    for (int c = 0; c < 3; ++c)
    {
      slope[c] = (8 * (near[0][c] - near[1][c]) - (far[0][c] - far[1][c])) / 12;
    }
    return slope;
  };
  long double volume = 0.0L;
  for (std::size_t i = 0; i < 8; ++i)
  {
    for (std::size_t j = 0; j < 8; ++j)
    {
      for (std::size_t k = 0; k < 8; ++k)
      {
        const LongVec3 u{ points[i], points[j], points[k] };
        const LongVec3 a = derivative(u, 0);
        const LongVec3 b = derivative(u, 1);
        const LongVec3 c = derivative(u, 2);
        volume += weights[i] * weights[j] * weights[k] *
          (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]));
      }
    }
  }
  return volume;
}

void ExpectNear(const Estimate& found, double value, double error, const char* what)
{
  EXPECT_NEAR(found.value, value, error) << what;
  EXPECT_GE(found.error + 1e-14, std::fabs(found.value - value)) << what;
}
} // namespace

TEST(FieldNorms, TheVolumeOfBentCubes)
{
  const auto exact = static_cast<double>(VolumeOfBend());
  for (const std::span<const Shape> shapes : { std::span<const Shape>(kHexahedra),
         std::span<const Shape>(kPrisms), std::span<const Shape>(kTetrahedra),
         std::span<const Shape>(kPyramids), std::span<const Shape>(kMixed) })
  {
    const NormCase one(shapes, 1, [](const LongVec3&) { return 1.0L; });
    const FieldNorms norms = one.Norms();
    ExpectNear(norms.volume, exact, 1e-13 * exact, Name(shapes[0]));
    ExpectNear(norms.l1, exact, 1e-13 * exact, Name(shapes[0]));
    ExpectNear(norms.l2, std::sqrt(exact), 1e-13 * exact, Name(shapes[0]));
    ExpectNear(norms.integrals[0], exact, 1e-13 * exact, Name(shapes[0]));
    EXPECT_TRUE(norms.met);
    EXPECT_EQ(norms.folded + norms.notFinite, 0);
    EXPECT_NEAR(norms.largest, 1.0, 1e-14);
  }
}

TEST(FieldNorms, OfAStraightCubeInClosedForm)
{
  MeshBuilder builder;
  builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  const Mesh mesh = builder.View();
  ExpansionBuilder values(1);
  // x - 1/3: its sign changes inside.
  values.Add(UniformSpace(Shape::Hexahedron, 3),
    [](const LongVec3& xi, long double* v) { *v = xi[0] - 1.0L / 3.0L; });
  Field field;
  field.name = "u";
  field.values = values.View();
  const FieldNorms norms = FindNorms(mesh, field, 0.0);
  ExpectNear(norms.volume, 8.0, 2e-13, "volume");
  // 4 times the integral of |x - 1/3| over [-1, 1], which is 8/9 + 2/9.
  ExpectNear(norms.l1, 40.0 / 9.0, 1e-4, "L1");
  ExpectNear(norms.l2, std::sqrt(8.0 / 3.0 + 8.0 / 9.0), 2e-13, "L2");
  ExpectNear(norms.integrals[0], -8.0 / 3.0, 2e-13, "integral");
  const auto largest = LargestMagnitude(mesh, field);
  ASSERT_TRUE(largest.has_value());
  EXPECT_TRUE(largest->Contains(4.0 / 3.0));
  EXPECT_LT(largest->Width(), 1e-5);
  EXPECT_EQ(CountWithPart(norms, 0.9), 1);
  // As the slab of a square of side 2.
  const FieldNorms plane = FindNorms(mesh, field, 2.0);
  ExpectNear(plane.volume, 4.0, 2e-13, "area");
  ExpectNear(plane.l2, std::sqrt(4.0 / 3.0 + 4.0 / 9.0), 2e-13, "L2 of the plane");
}

TEST(FieldNorms, ElementsAreOrderedByTheirPart)
{
  // 1 in one of eight blocks, 0.1 in the others.
  MeshBuilder builder;
  ExpansionBuilder values(1);
  for (int k = 0; k < 8; ++k)
  {
    builder.Add(UniformSpace(Shape::Hexahedron, 1),
      [k](const LongVec3& xi) {
        return LongVec3{ xi[0] + 2.0L * k, xi[1], xi[2] };
      });
    values.Add(UniformSpace(Shape::Hexahedron, 1),
      [k](const LongVec3&, long double* v) { *v = k == 5 ? 1.0L : 0.1L; });
  }
  Field field;
  field.name = "u";
  field.values = values.View();
  const FieldNorms norms = FindNorms(builder.View(), field, 0.0);
  EXPECT_EQ(OrderBySquare(norms).front(), 5);
  EXPECT_EQ(CountWithPart(norms, 0.9), 1); // 1 / 1.07
  EXPECT_EQ(CountWithPart(norms, 0.95), 3);
  EXPECT_EQ(CountWithPart(norms, 0.0), 0);
  EXPECT_EQ(norms.largestElement, 5);
}

TEST(FieldNorms, ThreadsChangeNothing)
{
  const NormCase one(kMixed, 3, [](const LongVec3& xi) { return xi[0] * xi[1] - 0.1L; });
  std::vector<double> found;
  for (const std::size_t threads : { 1, 4 })
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const FieldNorms norms = one.Norms();
    found.insert(found.end(), { norms.l1.value, norms.l1.error, norms.l2.value });
  }
  EXPECT_TRUE(std::equal(found.begin(), found.begin() + 3, found.begin() + 3));
}

TEST(FieldNorms, ValuesThatAreNotFiniteAreLeftOut)
{
  MeshBuilder builder;
  std::vector<double> modes;
  ExpansionBuilder values(1);
  for (int k = 0; k < 2; ++k)
  {
    builder.Add(UniformSpace(Shape::Hexahedron, 1),
      [k](const LongVec3& xi) {
        return LongVec3{ xi[0] + 2.0L * k, xi[1], xi[2] };
      });
    values.Add(
      UniformSpace(Shape::Hexahedron, 1), [](const LongVec3&, long double* v) { *v = 2.0L; });
  }
  Field field;
  field.name = "u";
  field.values = values.View();
  modes.assign(field.values.coefficients.begin(), field.values.coefficients.end());
  modes[0] = NAN;
  field.values.coefficients = modes;
  const FieldNorms norms = FindNorms(builder.View(), field, 0.0);
  EXPECT_EQ(norms.notFinite, 1);
  EXPECT_NEAR(norms.l1.value, 16.0, 1e-13);
  EXPECT_NEAR(norms.volume.value, 8.0, 1e-13);
}
} // namespace pixelexact::testing
