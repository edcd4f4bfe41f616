// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/HessianFunction.h"

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

/// The symmetric matrix of second derivatives by xi: 11, 12, 13, 22, 23, 33.
std::array<Interval, 6> ByXi(Shape shape, std::span<const Interval> p, std::size_t function,
  const Interval& r3, const Interval& r23)
{
  const auto second = p.subspan(kSecond + 6 * function, 6);
  const auto over = [](const Interval& v, const Interval& r, bool divided)
  { return divided ? v * r : v; };
  const bool curved1 = shape != Shape::Hexahedron;
  const bool curved2 = HessianFunction::IsDivided(shape, 1, 2);
  std::array<Interval, 6> result;
  result[0] = over(second[0], r23, curved1);
  result[1] = over(second[1], r23, curved1);
  result[2] = over(second[3], r23, curved1);
  result[3] = over(second[2], r3, curved2);
  const Interval by2 = over(second[4], r3, curved2);
  result[4] = by2;
  result[5] = second[5];
  if (shape == Shape::Tetrahedron)
  {
    result[3] = result[3] + p[kE1] * result[1];
    result[4] = result[4] + p[kE1] * result[2];
  }
  if (curved1)
  {
    result[5] = result[5] + p[kE1] * result[2];
  }
  if (curved2)
  {
    result[5] = result[5] + p[kE2] * by2;
  }
  return result;
}

constexpr Box3 kWholePiece{ Vec3(-1.0), Vec3(1.0) };

/// The six: G^(xi) by eta.
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

/// A polynomial of one degree less, without its error: coefficient(at, k) for the k-th along a
/// direction, which stands at `at` in the given one.
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

/// The bound of the error where coefficients are multiplied by `scale` at most.
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

/// Over h = (1 - eta_direction) / 2, on a piece that ends at eta_direction = 1, where the exact
/// polynomial vanishes: of h (n / (n - k)) B^(n-1)_k = B^n_k, scaled to the piece.
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

/// Whether the division is one of coefficients.
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

/// What is left to divide by: h, or 1.
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

std::array<HessianFunction::XiRanges, 4> HessianFunction::RangesByXi(
  Shape shape, std::span<const Interval> hulls)
{
  const Interval r3 = Interval(1.0) / hulls[kH3];
  const Interval r23 = shape == Shape::Tetrahedron ? r3 / hulls[kH2] : r3;
  std::array<XiRanges, 4> ranges;
  for (std::size_t f = 0; f < 4; ++f)
  {
    std::copy_n(hulls.begin() + static_cast<std::ptrdiff_t>(3 * f), 3, ranges[f].first.begin());
    ranges[f].second = ByXi(shape, hulls, f, r3, r23);
  }
  return ranges;
}
} // namespace pixelexact
