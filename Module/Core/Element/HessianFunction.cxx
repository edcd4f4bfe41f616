// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/HessianFunction.h"

#include <algorithm>

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
template <class T>
using Symmetric = std::array<T, 6>;

template <class T>
Symmetric<T> ByXi(
  Shape shape, std::span<const T> p, std::size_t function, const T& r3, const T& r23)
{
  const auto second = p.subspan(kSecond + 6 * function, 6);
  const auto over = [](const T& v, const T& r, bool divided) { return divided ? v * r : v; };
  const bool curved1 = shape != Shape::Hexahedron;
  const bool curved2 = HessianFunction::IsDivided(shape, 1, 2);
  Symmetric<T> result;
  result[0] = over(second[0], r23, curved1);
  result[1] = over(second[1], r23, curved1);
  result[2] = over(second[3], r23, curved1);
  result[3] = over(second[2], r3, curved2);
  const T by2 = over(second[4], r3, curved2);
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

constexpr std::size_t kPlace[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };

template <class T>
using Vector = std::array<T, 3>;

template <class T>
T Bilinear(const Vector<T>& v, const Symmetric<T>& matrix, const Vector<T>& w)
{
  T sum(0.0);
  for (std::size_t j = 0; j < 3; ++j)
  {
    T row(0.0);
    for (std::size_t k = 0; k < 3; ++k)
    {
      row = row + matrix[kPlace[j][k]] * w[k];
    }
    sum = sum + v[j] * row;
  }
  return sum;
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

template <class T>
T HessianFunction::Combine(std::span<const T> p) const
{
  const T r3 = Reciprocal(p[kH3]);
  const T r23 = TheShape == Shape::Tetrahedron ? Reciprocal(p[kH2]) * r3 : r3;
  const auto cofactor = [&](std::size_t i, std::size_t j)
  {
    const auto at = [&](std::size_t k, std::size_t l)
    { return p[3 * ((i + k) % 3) + (j + l) % 3]; };
    return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
  };
  std::array<Vector<T>, 3> cofactors; // [i][j], det J times J^-1_ji
  for (std::size_t i = 0; i < 3; ++i)
  {
    cofactors[i] = { cofactor(i, 0), cofactor(i, 1), cofactor(i, 2) };
  }
  const T inverse =
    Reciprocal(p[0] * cofactors[0][0] + p[1] * cofactors[0][1] + p[2] * cofactors[0][2]);
  Symmetric<T> matrix = ByXi(TheShape, p, 3, r3, r23);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto& row = cofactors[c];
    const T slope = (row[0] * p[9] + row[1] * p[10] + row[2] * p[11]) * inverse;
    const Symmetric<T> bend = ByXi(TheShape, p, c, r3, r23);
    for (std::size_t k = 0; k < 6; ++k)
    {
      matrix[k] = matrix[k] - slope * bend[k];
    }
  }
  for (auto& row : cofactors)
  {
    for (T& entry : row)
    {
      entry = entry * inverse;
    }
  }
  if (Directions)
  {
    std::array<Vector<T>, 2> v;
    for (std::size_t side = 0; side < 2; ++side)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        v[side][j] = T((*Directions)[side][0]) * cofactors[0][j] +
          T((*Directions)[side][1]) * cofactors[1][j] + T((*Directions)[side][2]) * cofactors[2][j];
      }
    }
    return Bilinear(v[0], matrix, v[1]);
  }
  T square(0.0);
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = i; j < 3; ++j)
    {
      square =
        square + T(i == j ? 1.0 : 2.0) * Square(Bilinear(cofactors[i], matrix, cofactors[j]));
    }
  }
  return square;
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
    ranges[f].second = ByXi<Interval>(shape, hulls, f, r3, r23);
  }
  return ranges;
}

Interval HessianFunction::Enclose(std::span<const BoxPolynomial> polynomials) const
{
  std::vector<AffineForm> forms;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    forms.push_back(polynomial.Affine());
  }
  const AffineForm value = Combine<AffineForm>(forms);
  return Directions ? value.Range() : Sqrt(value.Range());
}

Interval HessianFunction::AtCorner(
  std::span<const BoxPolynomial> polynomials, unsigned corner) const
{
  std::vector<Interval> values;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    values.push_back(polynomial.AtCorner(corner));
  }
  const Interval value = Combine<Interval>(values);
  return Directions ? value : Sqrt(value);
}
} // namespace pixelexact
