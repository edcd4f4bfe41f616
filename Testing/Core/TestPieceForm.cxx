// SPDX-License-Identifier: BSD-3-Clause
// Bernstein coefficients of functions and derivatives on pieces, against sums of modes in 113 bits.
#include "MeshBuilder.h"
#include "QuadReference.h"
#include "RangeCases.h"

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Bernstein/PieceForm.h"
#include "Core/Element/HessianFunction.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr Part kParts[] = { Part::Value, Part::ByXi1, Part::ByXi2, Part::ByXi3 };

std::vector<Space> MakePieceSpaces()
{
  std::vector<Space> spaces = MakeSpaces({ 0, 1, 2, 3, 5, 8 });
  spaces.push_back({ Shape::Pyramid, Form::Tensor, { 3, 2, 7 } });
  spaces.push_back(UniformSpace(Shape::Hexahedron, 16));
  spaces.push_back(UniformSpace(Shape::Prism, 16));
  return spaces;
}

/// Bernstein sum in local coordinates of [-1, 1]^3.
Quad EvaluateBernstein(
  const std::array<int, 3>& degree, const std::vector<double>& b, const Vec3& t)
{
  const auto basis = [](int n, int i, double z)
  {
    Quad value(1);
    for (int k = 1; k <= i; ++k)
    {
      value = value * Quad(n - i + k) / Quad(k);
    }
    const Quad up = (Quad(1) + Quad(z)) * Quad(0.5);
    const Quad down = (Quad(1) - Quad(z)) * Quad(0.5);
    for (int k = 0; k < n; ++k)
    {
      value = value * (k < i ? up : down);
    }
    return value;
  };
  Quad sum;
  std::size_t at = 0;
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      const Quad ij = basis(degree[0], i, t.x) * basis(degree[1], j, t.y);
      for (int k = 0; k <= degree[2]; ++k)
      {
        sum = sum + Quad(b[at++]) * ij * basis(degree[2], k, t.z);
      }
    }
  }
  return sum;
}

/// The function's value or derivative at eta, in 113 bits.
Quad EvaluateQuadPart(
  const Space& space, const std::vector<double>& modes, Part part, const std::array<Quad, 3>& eta)
{
  const std::vector<Space> spaces{ space };
  const std::vector<std::int32_t> spaceOf{ 0 };
  const std::vector<std::int64_t> offset{ 0 };
  const Expansion one{ spaces, spaceOf, offset, modes, 1 };
  const auto all = EvaluateQuad(one, 0, ToXi(space.shape, eta));
  return part == Part::Value ? all[0].value
                             : all[0].gradient[static_cast<std::size_t>(static_cast<int>(part))];
}
} // namespace

TEST(PieceForm, SameFunctionsAndDerivatives)
{
  Random random(31);
  double largest = 0.0;
  for (const Space& space : MakePieceSpaces())
  {
    const auto modes = RandomModes(space, random);
    ASSERT_TRUE(PieceForm::IsClosed(space, modes.data()));
    const int usual = PieceForm::LevelOf(space.MaxOrder());
    for (int level = usual; level <= std::max(usual, 2); ++level)
    {
      const PieceForm& form = PieceForm::Of(space, level);
      std::vector<double> b(form.Size());
      for (const Part part : kParts)
      {
        const int pieces = 1 << level;
        const auto pick = [&] { return static_cast<int>(random(0.0, 0.999) * pieces); };
        const PieceForm::Piece piece{ pick(), pick(), pick() };
        form.Convert(part, piece, modes.data(), b);
        const double bound = form.ErrorBound(part, piece, modes.data());
        const Vec3 t(random(), random(), random());
        std::array<Quad, 3> eta;
        for (std::size_t d = 0; d < 3; ++d)
        {
          eta[d] = Quad((2.0 * piece[d] + 1.0) / pieces - 1.0) +
            Quad(t[static_cast<int>(d)]) / Quad(pieces);
        }
        const Quad expected = EvaluateQuadPart(space, modes, part, eta);
        const auto error =
          static_cast<double>(Abs(EvaluateBernstein(form.Degree(), b, t) - expected));
        EXPECT_LE(error, bound) << Name(space.shape) << space.MaxOrder() << " part "
                                << static_cast<int>(part) << " level " << level;
        largest = std::max(largest, error / bound);
        EXPECT_LE(bound, 1e-8) << Name(space.shape) << space.MaxOrder() << int(part) << level;
      }
    }
  }
  EXPECT_GT(largest, 1e-4); // the bound is not idle
}

TEST(PieceForm, CollapsedEdgesAndVertices)
{
  // x_j as functions of xi: their derivatives are the unit matrix there as anywhere.
  for (const Shape shape : { Shape::Prism, Shape::Tetrahedron, Shape::Pyramid })
  {
    for (int i = 0; i < 3; ++i)
    {
      const Space space = UniformSpace(shape, 2);
      const auto change = ChangeOfBasis::FromFunctions(
        space, 1, [i](const LongVec3& xi, long double* value) { *value = xi[i]; });
      std::vector<double> modes(space.Modes());
      change.Apply(std::vector<double>{ 1.0 }, 0.0, modes);
      const PieceForm& form = PieceForm::Of(space);
      std::vector<double> b(form.Size());
      for (int j = 0; j < 3; ++j)
      {
        form.Convert(static_cast<Part>(j), { 0, 0, 0 }, modes.data(), b);
        for (const double coefficient : b)
        {
          EXPECT_NEAR(coefficient, i == j ? 1.0 : 0.0, 1e-14) << Name(shape);
        }
      }
    }
  }
}

TEST(PieceForm, TellsOpenPyramids)
{
  const Space space{ Shape::Pyramid, Form::Tensor, { 1, 1, 1 } };
  std::vector<double> modes(8, 0.0);
  modes[0] = 1.0;
  EXPECT_TRUE(PieceForm::IsClosed(space, modes.data()));
  modes[6] = 1.0; // (1, 1, 0): open unless (1, 1, 1) takes it back at the apex
  EXPECT_FALSE(PieceForm::IsClosed(space, modes.data()));
  modes[7] = -1.0;
  EXPECT_TRUE(PieceForm::IsClosed(space, modes.data()));
}

TEST(BoxPolynomial, ChildrenAndRestricts)
{
  Random random(32);
  const Space space = UniformSpace(Shape::Hexahedron, 5);
  const auto modes = RandomModes(space, random);
  const PieceForm& form = PieceForm::Of(space);
  BoxPolynomial whole{ form.Degree(), std::vector<double>(form.Size()) };
  form.Convert(Part::Value, { 0, 0, 0 }, modes.data(), whole.b);
  whole.error = form.ErrorBound(Part::Value, { 0, 0, 0 }, modes.data());
  for (int trial = 0; trial < 50; ++trial)
  {
    BoxPolynomial part = whole;
    std::array<double, 3> lower{};
    std::array<double, 3> upper{};
    for (int d = 0; d < 3; ++d)
    {
      const double a = random();
      const double b = random();
      lower[d] = std::min(a, b);
      upper[d] = std::max(a, b);
      part.Restrict(d, lower[d], upper[d]);
    }
    const BoxPolynomial upperHalf = part.Subdivide(1);
    const Vec3 t(random(), random(), random());
    for (const bool isUpper : { false, true })
    {
      std::array<Quad, 3> eta;
      for (int d = 0; d < 3; ++d)
      {
        const double local = d != 1 ? t[d] : (t[d] + (isUpper ? 1.0 : -1.0)) / 2.0;
        eta[d] = (Quad(lower[d]) + Quad(upper[d])) * Quad(0.5) +
          (Quad(upper[d]) - Quad(lower[d])) * Quad(0.5) * Quad(local);
      }
      const BoxPolynomial& box = isUpper ? upperHalf : part;
      const Quad expected = EvaluateQuadPart(space, modes, Part::Value, eta);
      // t[1] / 2 + 1 / 2 is rounded: one more roundoff times the slope.
      EXPECT_LE(static_cast<double>(Abs(EvaluateBernstein(box.degree, box.b, t) - expected)),
        2.0 * box.error);
      const auto value = static_cast<double>(expected);
      EXPECT_TRUE(box.Hull().Contains(value));
      EXPECT_TRUE(box.Affine().Range().Contains(value));
    }
  }
}

TEST(AffineForm, EnclosesEveryOperation)
{
  Random random(33);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const double size = std::pow(2.0, -std::floor(random(0.0, 30.0)));
    const auto make = [&](double middle)
    {
      AffineForm f(middle);
      for (double& slope : f.b)
      {
        slope = size * random();
      }
      f.e = { -size * size * random(0.0, 1.0), size * size * random(0.0, 1.0) };
      return f;
    };
    const AffineForm f = make(random());
    const AffineForm g = make(random());
    const Vec3 t(random(), random(), random());
    const auto at = [&](const AffineForm& form, double part)
    {
      Quad value =
        Quad(form.a) + Quad(form.e.lower) + (Quad(form.e.upper) - Quad(form.e.lower)) * Quad(part);
      for (int d = 0; d < 3; ++d)
      {
        value = value + Quad(form.b[d]) * Quad(t[d]);
      }
      return value;
    };
    const Quad x = at(f, random(0.0, 1.0));
    const Quad y = at(g, random(0.0, 1.0));
    const auto holds = [&](const AffineForm& form, const Quad& value)
    {
      return !(value < at(form, 0.0)) && !(at(form, 1.0) < value) &&
        !(value < Quad(form.Range().lower)) && !(Quad(form.Range().upper) < value);
    };
    EXPECT_TRUE(holds(f + g, x + y));
    EXPECT_TRUE(holds(f - g, x - y));
    EXPECT_TRUE(holds(f * g, x * y));
    EXPECT_TRUE(holds(Square(f), x * x));
    const AffineForm r = Reciprocal(f);
    if (r.e.IsFinite())
    {
      EXPECT_TRUE(holds(r, Quad(1) / x));
    }
    else
    {
      EXPECT_TRUE(f.Range().Contains(0.0));
    }
  }
}

namespace
{
/// The six second derivatives by xi of a field's component 0: differences of gradients in 113 bits.
std::array<double, 6> SecondDerivativesQuad(const Field& field, const QuadVec3& xi)
{
  constexpr std::size_t kFirst[] = { 0, 0, 0, 1, 1, 2 };
  constexpr std::size_t kSecond[] = { 0, 1, 2, 1, 2, 2 };
  const Quad step(0x1p-30);
  std::array<double, 6> result{};
  for (std::size_t k = 0; k < 6; ++k)
  {
    QuadVec3 before = xi;
    QuadVec3 after = xi;
    before[kSecond[k]] = xi[kSecond[k]] - step;
    after[kSecond[k]] = xi[kSecond[k]] + step;
    const Quad difference = EvaluateQuad(field.values, 0, after)[0].gradient[kFirst[k]] -
      EvaluateQuad(field.values, 0, before)[0].gradient[kFirst[k]];
    result[k] = static_cast<double>(difference / (step + step));
  }
  return result;
}

/// Ranges of the derivatives of the case's field over a piece, in the field's units.
HessianFunction::XiRanges RangesOver(const RangeCase& one, int level, const PieceForm::Piece& piece)
{
  const ScaledModes map(one.mesh.map.SpaceOf(0), one.mesh.map.Coefficients(0), 3);
  const ScaledModes values(one.field.values.SpaceOf(0), one.field.values.Coefficients(0), 1);
  std::vector<Interval> hulls;
  for (const BoxPolynomial& polynomial : HessianFunction::Polynomials(map, values, 0, level, piece))
  {
    hulls.push_back(polynomial.Hull());
  }
  auto ranges = HessianFunction::RangesByXi(one.mesh.ShapeOf(0), hulls)[3];
  for (Interval& range : ranges.second)
  {
    range = Scaled(range, values.exponent);
  }
  return ranges;
}
} // namespace

TEST(HessianFunction, RangesHoldSecondDerivativesByXi)
{
  constexpr int kLevel = 2;
  Random random(51);
  for (const Shape shape : kShapes)
  {
    for (int order = 1; order <= 8; ++order)
    {
      RangeCase one(UniformSpace(shape, 2), [](const LongVec3& xi) { return xi; });
      one.SetNoise(order, random, 0.7);
      for (int i = 0; i < 20; ++i)
      {
        PieceForm::Piece piece{};
        QuadVec3 eta;
        for (std::size_t d = 0; d < 3; ++d)
        {
          piece[d] = static_cast<int>(random(0.0, 4.0));
          // Ends of pieces too, where extremes are likely; not where eta is collapsed.
          const double within = std::clamp(random(-0.3, 1.3), 0.0, 1.0);
          eta[d] = std::min((piece[d] + within) / 2.0 - 1.0, 1.0 - 0x1p-10);
        }
        const auto ranges = RangesOver(one, kLevel, piece).second;
        const auto exact = SecondDerivativesQuad(one.field, ToXi(shape, eta));
        const bool isAtApex = shape == Shape::Pyramid && piece[2] == 3;
        for (std::size_t k = 0; k < 6; ++k)
        {
          const double slack = 1e-12 * (1.0 + std::fabs(exact[k]));
          EXPECT_LE(exact[k], ranges[k].upper + slack) << Name(shape) << order << ", " << k;
          EXPECT_GE(exact[k], ranges[k].lower - slack) << Name(shape) << order << ", " << k;
          EXPECT_TRUE(isAtApex || ranges[k].IsFinite()) << Name(shape) << order << ", " << k;
        }
      }
    }
  }
}

/// Second derivatives of quadratics of xi are bounded over whole elements, also where prisms and
/// tetrahedra are collapsed. Terms with e1 and e2 cancel exactly, but not in interval arithmetic:
/// that costs twice the largest mixed derivative.
TEST(HessianFunction, QuadraticsAreBoundedAtCollapsedEdges)
{
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
  {
    RangeCase one(UniformSpace(shape, 2), [](const LongVec3& xi) { return xi; });
    ExpansionBuilder made(1);
    made.Add(UniformSpace(shape, 2),
      [](const LongVec3& xi, long double* value)
      {
        const auto [a, b, c] = xi;
        *value = a * a - 3 * a * b + 0.5L * c * c + 2 * b * c + b - 7;
      });
    one.SetField(made.Spaces[0], made.Coefficients);
    const auto ranges = RangesOver(one, 0, {}).second;
    constexpr double kExact[] = { 2.0, -3.0, 0.0, 0.0, 2.0, 1.0 };
    for (std::size_t k = 0; k < 6; ++k)
    {
      EXPECT_TRUE(ranges[k].Contains(kExact[k])) << Name(shape) << ", " << k;
      EXPECT_LT(ranges[k].Width(), shape == Shape::Hexahedron ? 1e-12 : 6.0 + 1e-10)
        << Name(shape) << ", " << k;
    }
  }
}
} // namespace pixelexact::testing
