// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/Elements.h"

#include "Core/Basis/LineFunctions.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Location/Sample.h"

#include <numbers>

namespace pixelexact::testing
{
namespace
{
constexpr long double kLongPi = std::numbers::pi_v<long double>;
constexpr int kSpiralOrder = 20;

LongVec3 Apply(const LongMat3& m, const LongVec3& x)
{
  LongVec3 y{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      y[i] += m[i][j] * x[j];
    }
  }
  return y;
}

/// The power of two next below `extent`.
double SizeFor(double extent)
{
  return std::exp2(std::floor(std::log2(extent)));
}

/// One element given by its modes.
void AddModes(MeshBuilder& mesh, const Space& space, const std::vector<double>& modes)
{
  auto& phi = mesh.Phi;
  phi.SpaceOf.push_back(static_cast<std::int32_t>(phi.Spaces.size()));
  phi.Spaces.push_back(space);
  phi.Offset.push_back(static_cast<std::int64_t>(phi.Coefficients.size()));
  phi.Coefficients.insert(phi.Coefficients.end(), modes.begin(), modes.end());
  mesh.Centre.insert(mesh.Centre.end(), 3, 0.0);
  mesh.Size.push_back(1.0);
  mesh.Uncertainty.push_back(0.0);
}

/// Three components of `from` in the space `to`.
std::vector<double> LiftMap(const MeshBuilder& from, const Space& to)
{
  const Expansion map = from.View().map;
  const Space& space = map.SpaceOf(0);
  std::vector<double> modes;
  for (int c = 0; c < 3; ++c)
  {
    const auto component =
      Lift(space, map.Coefficients(0) + static_cast<std::ptrdiff_t>(c) * space.Modes(), to);
    modes.insert(modes.end(), component.begin(), component.end());
  }
  return modes;
}

std::vector<double> RandomMapModes(const Space& space, Random& random)
{
  std::vector<double> modes;
  for (int c = 0; c < 3; ++c)
  {
    ForEachMode(space,
      [&](int p, int q, int r, int)
      { modes.push_back(random() * std::exp2(-(p + q + r)) / ModeBound(space, p, q, r)); });
  }
  return modes;
}

/// The largest row sum of the Jacobian of `modes`, over points of the enlarged shape.
double LargestSlope(const Space& space, const std::vector<double>& identity,
  const std::vector<double>& modes, double reach, Random& random)
{
  constexpr int kPoints = 600;
  std::vector<Vec3> xi;
  for (int i = 0; i < kPoints; ++i)
  {
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      // Half of the coordinates at the ends, where polynomials are steepest.
      const double upper = d == 2 && space.shape != Shape::Hexahedron ? 1.0 : 1.0 + reach;
      const double at = random(-2.0, 2.0);
      eta[d] = at < -1.0 ? -1.0 - reach : (at > 1.0 ? upper : at);
    }
    // The pyramid's functions have no gradient at the apex.
    eta.z = space.shape == Shape::Pyramid ? std::min(eta.z, 0.999) : eta.z;
    xi.push_back(TensorToReference(space.shape, eta));
  }
  MeshBuilder unit;
  AddModes(unit, space, identity);
  const Mesh mesh = unit.View();
  Field field{ "perturbation", mesh.map };
  field.values.coefficients = modes;
  std::vector<double> gradient(9 * xi.size());
  EvaluateAt(mesh, field, 0, xi, {}, gradient);
  double largest = 0.0;
  for (std::size_t k = 0; k < gradient.size(); k += 3)
  {
    largest = std::max(
      largest, std::fabs(gradient[k]) + std::fabs(gradient[k + 1]) + std::fabs(gradient[k + 2]));
  }
  return largest;
}
} // namespace

LongMat3 Identity()
{
  return Diagonal(1, 1, 1);
}

LongMat3 Diagonal(long double x, long double y, long double z)
{
  return { { { x, 0, 0 }, { 0, y, 0 }, { 0, 0, z } } };
}

LongMat3 Product(const LongMat3& a, const LongMat3& b)
{
  LongMat3 product{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        product[i][j] += a[i][k] * b[k][j];
      }
    }
  }
  return product;
}

LongMat3 Rotation()
{
  const auto about = [](int axis, long double angle)
  {
    LongMat3 m = Identity();
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    m[i][i] = m[j][j] = std::cos(angle);
    m[i][j] = -std::sin(angle);
    m[j][i] = std::sin(angle);
    return m;
  };
  return Product(about(0, 0.7L), Product(about(1, -1.1L), about(2, 0.4L)));
}

LongMat3 Skew(double degrees)
{
  const long double angle = degrees * kLongPi / 180;
  return { { { 1, std::cos(angle), 0 }, { 0, std::sin(angle), 0 }, { 0, 0, 1 } } };
}

void AddAffine(
  MeshBuilder& mesh, Shape shape, const LongMat3& matrix, double size, const Vec3& centre)
{
  // About the origin, and then moved: exact.
  mesh.Add(
    UniformSpace(shape, 3),
    [&](const LongVec3& xi)
    {
      LongVec3 x = Apply(matrix, Curved(xi));
      for (long double& coordinate : x)
      {
        coordinate *= size;
      }
      return x;
    },
    Vec3(0.0), SizeFor(size));
  for (int d = 0; d < 3; ++d)
  {
    mesh.Centre[mesh.Centre.size() - 3 + static_cast<std::size_t>(d)] = centre[d];
  }
}

void AddPerturbed(MeshBuilder& mesh, const Space& space, double reach)
{
  MeshBuilder linear;
  linear.Add(UniformSpace(space.shape, 1), [](const LongVec3& xi) { return xi; });
  auto modes = LiftMap(linear, space);
  Random random(100 + static_cast<std::uint64_t>(space.MaxOrder()));
  const auto perturbation = RandomMapModes(space, random);
  const double scale = 0.3 / LargestSlope(space, modes, perturbation, reach, random);
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    modes[k] += scale * perturbation[k];
  }
  AddModes(mesh, space, modes);
}

void AddPinched(MeshBuilder& mesh, Shape shape, double least)
{
  mesh.Add(UniformSpace(shape, 3),
    [&](const LongVec3& xi)
    {
      const auto [a, b, c] = xi;
      return Apply(Rotation(), { least * a + a * a * a / 3, b + 0.2L * a * a, c + 0.1L * a * b });
    });
}

int AddLetterC(MeshBuilder& mesh, Shape shape, double closed)
{
  const int order = shape == Shape::Hexahedron ? 2 : 3;
  mesh.Add(UniformSpace(shape, order),
    [&](const LongVec3& xi) -> LongVec3
    {
      const auto [a, b, c] = xi;
      const long double radius = 1 + 0.3L * b;
      return { radius * 3 * (1 - a * a - closed), radius * a, c };
    });
  return order;
}

std::array<long double, 2> SpiralMidline(double turns, long double a)
{
  // Each turn is 1.8 times farther out than the one before it, more than its thickness.
  const auto points = GaussLobattoPoints(kSpiralOrder + 1);
  std::vector<long double> weight(points.size());
  Lagrange(points).evaluate(a, weight.data());
  std::array<long double, 2> x{};
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const long double radius = std::pow(1.8L, turns * points[k] / 2);
    x[0] += weight[k] * radius * std::cos(kLongPi * turns * points[k]);
    x[1] += weight[k] * radius * std::sin(kLongPi * turns * points[k]);
  }
  return x;
}

Space SpiralHexahedron()
{
  return { Shape::Hexahedron, Form::Collapsed, { kSpiralOrder, 1, 1 } };
}

Space SpiralPrism()
{
  return { Shape::Prism, Form::Collapsed, { 1, kSpiralOrder, 1 } };
}

void AddSpiral(MeshBuilder& mesh, const Space& space, double turns)
{
  const bool prism = space.shape == Shape::Prism;
  MeshBuilder thin;
  thin.Add(prism ? SpiralPrism() : SpiralHexahedron(),
    [&](const LongVec3& xi) -> LongVec3
    {
      const auto [x, y] = SpiralMidline(turns, prism ? xi[1] : xi[0]);
      const long double radius = 1 + 0.12L * (prism ? xi[0] : xi[1]);
      return { radius * x, radius * y, xi[2] };
    });
  AddModes(mesh, space, LiftMap(thin, space));
}

std::vector<double> Lift(const Space& from, const double* modes, const Space& to)
{
  std::map<std::array<int, 3>, double> known;
  ForEachMode(from, [&](int p, int q, int r, int mode) { known[{ p, q, r }] = modes[mode]; });
  std::vector<double> lifted;
  ForEachMode(to,
    [&](int p, int q, int r, int)
    {
      const auto entry = known.find({ p, q, r });
      lifted.push_back(entry == known.end() ? 0.0 : entry->second);
    });
  return lifted;
}
} // namespace pixelexact::testing
