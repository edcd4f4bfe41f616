// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Bounds/AnalyticInverse.h"
#include "Core/Shape/Shape.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace pixelexact::testing
{
namespace
{
using Complex = std::complex<long double>;
template <class T>
using Triple = std::array<T, 3>;

/// A map and a field of degree 3, for real and for complex arguments.
template <class T>
Triple<T> BentPlace(const Triple<T>& xi)
{
  const auto& [a, b, c] = xi;
  return { a + 0.21L * b * b - 0.05L * c * a + 0.03L * b * b * c,
    0.9L * b + 0.08L * a * c - 0.14L * a * a + 0.02L * c * c * c,
    c + 0.06L * a * b + 0.05L * a * a * b };
}
template <class T>
T BentField(const Triple<T>& xi)
{
  const auto& [a, b, c] = xi;
  return 0.3L + a * b - 0.7L * c * c * c + 0.4L * a * a * c - 2.0L * b;
}

/// eta to xi.
template <class T>
Triple<T> ReferenceOf(Shape shape, const Triple<T>& eta)
{
  const T one(1.0L);
  const T h = (one - eta[2]) * 0.5L;
  switch (shape)
  {
    case Shape::Prism:
      return { (one + eta[0]) * h - one, eta[1], eta[2] };
    case Shape::Tetrahedron:
      return { (one + eta[0]) * (one - eta[1]) * 0.5L * h - one, (one + eta[1]) * h - one, eta[2] };
    case Shape::Pyramid:
      return { (one + eta[0]) * h - one, (one + eta[1]) * h - one, eta[2] };
    default:
      return eta;
  }
}

/// z of a complex eta, from the formulas alone.
struct ComplexCoordinates
{
  ComplexCoordinates(Shape shape, const AnalyticInverse& inverse)
    : Of(shape)
    , Frame(inverse)
  {
  }
  [[nodiscard]] Triple<Complex> EtaOf(const Triple<Complex>& s) const
  {
    Triple<Complex> eta;
    for (int d = 0; d < 3; ++d)
    {
      const Complex part = s[static_cast<std::size_t>(d)];
      eta[static_cast<std::size_t>(d)] = static_cast<long double>(Frame.centre[d]) +
        static_cast<long double>(Frame.halfWidth[d]) * part;
    }
    return eta;
  }
  [[nodiscard]] Triple<Complex> operator()(const Triple<Complex>& s) const
  {
    const Triple<Complex> x = BentPlace(ReferenceOf(Of, EtaOf(s)));
    Triple<Complex> z{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        z[i] += static_cast<long double>(Frame.inverse[3 * i + c]) *
          (x[c] - static_cast<long double>(Frame.origin[c]));
      }
    }
    return z;
  }
  /// By s <- s - (z(s) - z), which converges where the proof holds.
  [[nodiscard]] Triple<Complex> Solve(const Triple<Complex>& z) const
  {
    Triple<Complex> s = z;
    for (int step = 0; step < 2000; ++step)
    {
      const Triple<Complex> at = (*this)(s);
      for (std::size_t d = 0; d < 3; ++d)
      {
        s[d] -= at[d] - z[d];
      }
    }
    return s;
  }

  Shape Of;
  const AnalyticInverse& Frame;
};

long double Largest(const Triple<Complex>& v)
{
  return std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
}

struct BentElement
{
  MeshBuilder mesh;
  ExpansionBuilder field{ 1 };
  Shape shape;

  explicit BentElement(Shape of)
    : shape(of)
  {
    const Space space = UniformSpace(of, 3);
    mesh.Add(space,
      [](const LongVec3& xi)
      {
        const auto x = BentPlace<long double>({ xi[0], xi[1], xi[2] });
        return LongVec3{ x[0], x[1], x[2] };
      });
    field.Add(space,
      [](const LongVec3& xi, long double* value) {
        *value = BentField<long double>({ xi[0], xi[1], xi[2] });
      });
  }
};

const Box3 kBoxes[] = { { Vec3(-1.0), Vec3(1.0) }, { Vec3(-1.0), Vec3(0.0) },
  { Vec3(-0.5, 0.0, -1.0), Vec3(0.0, 0.5, -0.5) }, { Vec3(-0.125), Vec3(0.125) } };

Triple<Complex> OnSphere(Random& random, long double radius)
{
  Triple<Complex> z;
  for (Complex& part : z)
  {
    part = std::polar(radius, std::numbers::pi_v<long double> * random());
  }
  return z;
}

TEST(AnalyticInverse, EachComplexPointWithinReachHasItsPreimageInThePolydisc)
{
  Random random(7);
  int proven = 0;
  for (const Shape shape : kShapes)
  {
    const BentElement made(shape);
    const Mesh mesh = made.mesh.View();
    for (const Box3& box : kBoxes)
    {
      const AnalyticInverse inverse = MakeAnalyticInverse(mesh, 0, box);
      const ComplexCoordinates coordinates(shape, inverse);
      for (std::size_t k = 0; k < kDiscRadii.size(); ++k)
      {
        if (inverse.reach[k] <= 0.0)
        {
          continue;
        }
        ++proven;
        EXPECT_LT(inverse.reach[k], kDiscRadii[k]);
        const DiscBounds bounds = BoundsOverDiscs(made.field.View(), 0, box).front();
        const auto middle = BentField(ReferenceOf(shape, coordinates.EtaOf({})));
        for (int n = 0; n < 8; ++n)
        {
          const Triple<Complex> z = OnSphere(random, inverse.reach[k]);
          const Triple<Complex> s = coordinates.Solve(z);
          const Triple<Complex> again = coordinates(s);
          EXPECT_LT(Largest({ again[0] - z[0], again[1] - z[1], again[2] - z[2] }), 1e-12L);
          EXPECT_LE(Largest(s), kDiscRadii[k]);
          EXPECT_LE(
            std::abs(BentField(ReferenceOf(shape, coordinates.EtaOf(s))) - middle), bounds[k]);
        }
      }
    }
  }
  EXPECT_GT(proven, 30);
}

TEST(AnalyticInverse, InterpolatesAlongSegmentsWithinItsBound)
{
  Random random(11);
  int proven = 0;
  for (const Shape shape : kShapes)
  {
    const BentElement made(shape);
    const Mesh mesh = made.mesh.View();
    for (const Box3& box : kBoxes)
    {
      const AnalyticInverse inverse = MakeAnalyticInverse(mesh, 0, box);
      const DiscBounds bounds = BoundsOverDiscs(made.field.View(), 0, box).front();
      const ComplexCoordinates coordinates(shape, inverse);
      const auto value = [&](const Vec3& z)
      {
        const auto s = coordinates.Solve({ Complex(z.x), Complex(z.y), Complex(z.z) });
        return BentField(ReferenceOf(shape, coordinates.EtaOf(s))).real();
      };
      for (const int n : { 2, 4, 7 })
      {
        const Vec3 middle = 0.2 * Vec3(random(), random(), random());
        const Vec3 half = 0.2 * Vec3(random(), random(), random());
        const double bound = InterpolationError(inverse, bounds, middle, half, Vec3(0.0), n);
        if (!(bound < 1e3))
        {
          continue;
        }
        ++proven;
        std::vector<long double> node;
        std::vector<long double> at;
        for (int i = 0; i < n; ++i)
        {
          node.push_back(std::cos(std::numbers::pi_v<long double> * (2 * i + 1) / (2 * n)));
          at.push_back(value(middle + half * static_cast<double>(node.back())));
        }
        for (int m = -5; m <= 5; ++m)
        {
          const long double t = m / 5.0L;
          long double sum = 0.0L;
          for (std::size_t i = 0; i < node.size(); ++i)
          {
            long double term = at[i];
            for (std::size_t j = 0; j < node.size(); ++j)
            {
              term *= i == j ? 1.0L : (t - node[j]) / (node[i] - node[j]);
            }
            sum += term;
          }
          EXPECT_LE(std::fabs(sum - value(middle + half * static_cast<double>(t))), bound + 1e-12L);
        }
      }
    }
  }
  EXPECT_GT(proven, 20);
}

TEST(AnalyticInverse, NothingIsProvenOfDegenerateOrNonFiniteElements)
{
  MeshBuilder flat;
  flat.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi) {
      return LongVec3{ xi[0], xi[1], xi[0] };
    });
  const Box3 whole{ Vec3(-1.0), Vec3(1.0) };
  EXPECT_EQ(MakeAnalyticInverse(flat.View(), 0, whole).DiscOf(0.0), kDiscRadii.size());

  BentElement made(Shape::Hexahedron);
  made.field.Coefficients[3] = std::numeric_limits<double>::quiet_NaN();
  const AnalyticInverse inverse = MakeAnalyticInverse(made.mesh.View(), 0, whole);
  const DiscBounds bounds = BoundsOverDiscs(made.field.View(), 0, whole).front();
  EXPECT_EQ(InterpolationError(inverse, bounds, Vec3(0.0), Vec3(0.01), Vec3(0.0), 4),
    std::numeric_limits<double>::infinity());
}
} // namespace
} // namespace pixelexact::testing
