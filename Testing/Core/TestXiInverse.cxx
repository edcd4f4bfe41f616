// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Bounds/XiInverse.h"

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

/// z of complex s, from the formulas alone.
struct ComplexCoordinates
{
  explicit ComplexCoordinates(const XiInverse& inverse)
    : Frame(inverse)
  {
  }
  [[nodiscard]] Triple<Complex> XiOf(const Triple<Complex>& s) const
  {
    Triple<Complex> xi;
    for (int d = 0; d < 3; ++d)
    {
      const Complex part = s[static_cast<std::size_t>(d)];
      xi[static_cast<std::size_t>(d)] = static_cast<long double>(Frame.centre[d]) +
        static_cast<long double>(Frame.halfWidth[d]) * part;
    }
    return xi;
  }
  [[nodiscard]] Triple<Complex> operator()(const Triple<Complex>& s) const
  {
    const Triple<Complex> x = BentPlace(XiOf(s));
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

  const XiInverse& Frame;
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

/// The inverse over a box, and the field there.
struct OverBox
{
  OverBox(const BentElement& element, const Box3& box)
    : mesh(element.mesh.View())
    , inverse(MakeXiInverse(mesh, 0, SeriesOf(mesh.map, box), box))
    , values(SeriesOf(element.field.View(), box))
    , bounds(values.OverDiscs(0))
  {
  }
  static BoxSeries SeriesOf(const Expansion& function, const Box3& box)
  {
    return MakeBoxSeries(function.SpaceOf(0), function.Coefficients(0), function.components, box);
  }

  Mesh mesh;
  XiInverse inverse;
  BoxSeries values;
  DiscBounds bounds;
};

/// Shapes whose functions are polynomials of xi.
constexpr Shape kPolynomialShapes[] = { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron };

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

TEST(XiInverse, EachComplexPointWithinReachHasItsPreimageInThePolydisc)
{
  Random random(7);
  int proven = 0;
  for (const Shape shape : kPolynomialShapes)
  {
    const BentElement made(shape);
    for (const Box3& box : kBoxes)
    {
      const OverBox over(made, box);
      const XiInverse& inverse = over.inverse;
      const ComplexCoordinates coordinates(inverse);
      for (std::size_t k = 0; k < kDiscRadii.size(); ++k)
      {
        if (inverse.reach[k] <= 0.0)
        {
          continue;
        }
        ++proven;
        EXPECT_LT(inverse.reach[k], kDiscRadii[k]);
        const long double middle = over.values.coefficients[0][0];
        for (int n = 0; n < 8; ++n)
        {
          const Triple<Complex> z = OnSphere(random, inverse.reach[k]);
          const Triple<Complex> s = coordinates.Solve(z);
          const Triple<Complex> again = coordinates(s);
          EXPECT_LT(Largest({ again[0] - z[0], again[1] - z[1], again[2] - z[2] }), 1e-12L);
          EXPECT_LE(Largest(s), kDiscRadii[k]);
          EXPECT_LE(std::abs(BentField(coordinates.XiOf(s)) - middle), over.bounds[k]);
        }
      }
    }
  }
  EXPECT_GT(proven, 30);
}

TEST(XiInverse, InterpolatesAlongSegmentsWithinItsBound)
{
  Random random(11);
  int proven = 0;
  for (const Shape shape : kPolynomialShapes)
  {
    const BentElement made(shape);
    for (const Box3& box : kBoxes)
    {
      const OverBox over(made, box);
      const ComplexCoordinates coordinates(over.inverse);
      const auto value = [&](const Vec3& z)
      {
        const auto s = coordinates.Solve({ Complex(z.x), Complex(z.y), Complex(z.z) });
        return BentField(coordinates.XiOf(s)).real();
      };
      for (const int n : { 2, 4, 7 })
      {
        const Vec3 middle = 0.2 * Vec3(random(), random(), random());
        const Vec3 half = 0.2 * Vec3(random(), random(), random());
        const double bound = RayEllipses(over.inverse, middle, half).Error(over.bounds, n);
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

TEST(XiInverse, NothingIsProvenOfDegenerateElementsAndPyramids)
{
  const Box3 whole{ Vec3(-1.0), Vec3(1.0) };
  MeshBuilder flat;
  flat.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi) {
      return LongVec3{ xi[0], xi[1], xi[0] };
    });
  const Mesh mesh = flat.View();
  EXPECT_FALSE(MakeXiInverse(mesh, 0, OverBox::SeriesOf(mesh.map, whole), whole).IsProven());
  EXPECT_FALSE(OverBox(BentElement(Shape::Pyramid), whole).inverse.IsProven());
}
} // namespace
} // namespace pixelexact::testing
