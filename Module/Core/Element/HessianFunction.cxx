// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/HessianFunction.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pixelexact
{
namespace
{
/// Places in the list of polynomials (HessianFunction::Polynomials).
constexpr std::size_t kSecond = 12;
constexpr std::size_t kE1 = kSecond + 4 * 6;
constexpr std::size_t kE2 = kE1 + 1;
constexpr std::size_t kH2 = kE2 + 1;
constexpr std::size_t kH3 = kH2 + 1;

constexpr Box3 kWholePiece{ Vec3(-1.0), Vec3(1.0) };

/// The six derivatives of G^(xi) by eta.
struct Entry
{
  std::size_t byXi;
  int byEta;
};
constexpr Entry kEntries[6] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 0 }, { 2, 1 }, { 2, 2 } };

BoxPolynomial Zero()
{
  return { {}, { 0.0 }, 0.0 };
}

/// A polynomial of one degree less, without its error. coefficient(at, k) is the k-th along the
/// direction; `at` is the place of the k-th coefficient of the given polynomial.
template <class Coefficient>
BoxPolynomial Lowered(const BoxPolynomial& polynomial, int direction, Coefficient&& coefficient)
{
  BoxPolynomial result{ polynomial.degree, {}, 0.0 };
  const int n = result.degree[static_cast<std::size_t>(direction)]--;
  const std::size_t stride = StrideOf(polynomial.degree, direction);
  const std::size_t block = stride * static_cast<std::size_t>(n + 1);
  for (std::size_t start = 0; start < polynomial.b.size(); start += block)
  {
    for (std::size_t at = 0; at < block - stride; ++at)
    {
      result.b.push_back(coefficient(start + at, static_cast<int>(at / stride)));
    }
  }
  return result;
}

/// Bounds the error after coefficients are multiplied by at most `scale`.
double ErrorAfter(double scale, const BoxPolynomial& polynomial)
{
  return scale * (polynomial.error + Gamma(3) * LargestMagnitude(polynomial.b)) * (1.0 + Gamma(8)) +
    kUnderflow;
}

/// d / d eta_direction over a piece of width 2^(1 - level).
BoxPolynomial Differentiate(const BoxPolynomial& polynomial, int direction, int level)
{
  const int n = polynomial.degree[static_cast<std::size_t>(direction)];
  if (n == 0)
  {
    return Zero();
  }
  const std::size_t stride = StrideOf(polynomial.degree, direction);
  const double scale = std::ldexp(n, level - 1);
  BoxPolynomial result = Lowered(polynomial, direction,
    [&](std::size_t at, int /*k*/)
    { return scale * (polynomial.b[at + stride] - polynomial.b[at]); });
  result.error = ErrorAfter(2.0 * scale, polynomial);
  return result;
}

/// Divides by h = (1 - eta_direction) / 2, on a piece that ends at eta_direction = 1, where the
/// exact polynomial vanishes. From h (n / (n - k)) B^(n-1)_k = B^n_k, scaled to the piece.
BoxPolynomial DivideByH(const BoxPolynomial& polynomial, int direction, int level)
{
  const int n = polynomial.degree[static_cast<std::size_t>(direction)];
  if (n == 0)
  {
    return Zero();
  }
  const double scale = std::ldexp(n, level);
  BoxPolynomial result = Lowered(polynomial, direction,
    [&](std::size_t at, int k) { return polynomial.b[at] * (scale / static_cast<double>(n - k)); });
  result.error = ErrorAfter(scale, polynomial);
  return result;
}

/// (1 + sign eta_direction) / 2 over a piece, exactly.
BoxPolynomial Linear(int direction, double sign, int level, int piece)
{
  BoxPolynomial result{ {}, {}, 0.0 };
  result.degree[static_cast<std::size_t>(direction)] = 1;
  for (const int end : { piece, piece + 1 })
  {
    const double eta = std::ldexp(end, 1 - level) - 1.0;
    result.b.push_back((1.0 + sign * eta) / 2.0);
  }
  return result;
}

/// Whether the division acts on coefficients.
bool IsExact(Shape shape, int direction, int level, const PieceForm::Piece& piece)
{
  return shape != Shape::Pyramid && piece[static_cast<std::size_t>(direction)] == (1 << level) - 1;
}

void AddSeconds(Shape shape, const std::array<BoxPolynomial, 3>& slopes, int level,
  const PieceForm::Piece& piece, std::vector<BoxPolynomial>& list)
{
  for (const auto& [byXi, byEta] : kEntries)
  {
    BoxPolynomial second = Differentiate(slopes[byXi], byEta, level);
    for (const int direction : { 1, 2 })
    {
      if (HessianFunction::IsDivided(shape, byEta, direction) &&
        IsExact(shape, direction, level, piece))
      {
        second = DivideByH(second, direction, level);
      }
    }
    list.push_back(std::move(second));
  }
}

/// Whether all divisions by h act on coefficients.
bool IsExact(Shape shape, int level, const PieceForm::Piece& piece)
{
  const auto isFine = [&](int direction)
  {
    return !HessianFunction::IsDivided(shape, 0, direction) ||
      IsExact(shape, direction, level, piece);
  };
  return shape != Shape::Pyramid && isFine(1) && isFine(2);
}

/// The derivatives by xi of a polynomial in xi. Requires IsExact.
std::array<BoxPolynomial, 3> ByXi(
  Shape shape, const BoxPolynomial& f, int level, const PieceForm::Piece& piece)
{
  const auto byEta = [&](int derivative)
  {
    BoxPolynomial by = Differentiate(f, derivative, level);
    for (const int direction : { 1, 2 })
    {
      by = HessianFunction::IsDivided(shape, derivative, direction)
        ? DivideByH(by, direction, level)
        : by;
    }
    return by;
  };
  std::array<BoxPolynomial, 3> result{ byEta(0), byEta(1), byEta(2) };
  const BoxPolynomial first = result[0];
  const BoxPolynomial second = result[1];
  const BoxPolynomial e1 = Linear(0, 1.0, level, piece[0]);
  if (shape == Shape::Tetrahedron)
  {
    result[1] = Sum(second, Multiply(e1, first));
    result[2] = Sum(result[2], Multiply(Linear(1, 1.0, level, piece[1]), second));
  }
  if (shape != Shape::Hexahedron)
  {
    result[2] = Sum(result[2], Multiply(e1, first));
  }
  return result;
}

/// The remaining divisor: h, or 1.
BoxPolynomial Divisor(Shape shape, int direction, int level, const PieceForm::Piece& piece)
{
  return HessianFunction::IsDivided(shape, 0, direction) && !IsExact(shape, direction, level, piece)
    ? Linear(direction, -1.0, level, piece[static_cast<std::size_t>(direction)])
    : BoxPolynomial{ {}, { 1.0 }, 0.0 };
}
} // namespace

bool HessianFunction::IsDivided(Shape shape, int derivative, int direction)
{
  switch (shape)
  {
    case Shape::Prism:
      return derivative == 0 && direction == 2;
    case Shape::Tetrahedron:
      return derivative < direction;
    case Shape::Pyramid:
      return derivative < 2 && direction == 2;
    default:
      return false;
  }
}

std::vector<BoxPolynomial> HessianFunction::Polynomials(const ScaledModes& map,
  const ScaledModes& field, int component, int level, const PieceForm::Piece& piece)
{
  const Shape shape = map.space.shape;
  std::vector<RangeIngredient> ingredients;
  AddDerivatives(map, 0, 3, ingredients);
  AddDerivatives(field, component, 1, ingredients);
  std::vector<BoxPolynomial> list;
  std::vector<BoxPolynomial> seconds;
  for (std::size_t f = 0; f < 4; ++f)
  {
    std::array<BoxPolynomial, 3> slopes;
    for (std::size_t j = 0; j < 3; ++j)
    {
      slopes[j] = ingredients[3 * f + j].Over(level, piece, kWholePiece);
    }
    AddSeconds(shape, slopes, level, piece, seconds);
    std::ranges::move(slopes, std::back_inserter(list));
  }
  std::ranges::move(seconds, std::back_inserter(list));
  list.push_back(Linear(0, 1.0, level, piece[0]));
  list.push_back(Linear(1, 1.0, level, piece[1]));
  list.push_back(Divisor(shape, 1, level, piece));
  list.push_back(Divisor(shape, 2, level, piece));
  return list;
}

std::vector<BoxPolynomial> HessianFunction::Thirds(
  const ScaledModes& modes, int component, int level, const PieceForm::Piece& piece)
{
  const Shape shape = modes.space.shape;
  if (!IsExact(shape, level, piece))
  {
    return std::vector<BoxPolynomial>(10, { {}, { 0.0 }, kInfinity });
  }
  std::vector<BoxPolynomial> thirds;
  for (int j = 0; j < 3; ++j)
  {
    const BoxPolynomial slope =
      RangeIngredient{ &modes, component, kDerivatives[j] }.Over(level, piece, kWholePiece);
    const auto seconds = ByXi(shape, slope, level, piece);
    for (int k = j; k < 3; ++k)
    {
      auto byXi = ByXi(shape, seconds[static_cast<std::size_t>(k)], level, piece);
      std::move(byXi.begin() + k, byXi.end(), std::back_inserter(thirds));
    }
  }
  return thirds;
}

std::array<HessianFunction::XiRanges, 4> HessianFunction::RangesByXi(
  Shape shape, std::span<const Interval> hulls)
{
  const Interval r3 = Interval(1.0) / hulls[kH3];
  const Interval r23 = shape == Shape::Tetrahedron ? r3 / hulls[kH2] : r3;
  std::array<XiRanges, 4> ranges;
  for (std::size_t f = 0; f < 4; ++f)
  {
    std::copy_n(hulls.begin() + static_cast<std::ptrdiff_t>(3 * f), 3, ranges[f].first.begin());
    ranges[f].second = SecondsByXi<Interval>(
      shape, hulls.subspan(kSecond + 6 * f).first<6>(), hulls[kE1], hulls[kE2], r3, r23);
  }
  return ranges;
}
} // namespace pixelexact
