// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/QuantityFunction.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Element/JacobianAlgebra.h"
#include "Core/Math/Mat.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// The number of the map's derivatives.
constexpr std::size_t kOfMap = 9;

template <class T>
T SquaredNorm(const std::vector<T>& v)
{
  T sum(0.0);
  for (const T& component : v)
  {
    sum = sum + Square(component);
  }
  return sum;
}

std::vector<AffineForm> AffineForms(std::span<const BoxPolynomial> polynomials)
{
  std::vector<AffineForm> forms;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    forms.push_back(polynomial.Affine());
  }
  return forms;
}

/// The norm of v over the box: the intersection of two bounds. The sum of squares is sharp where v
/// is large; |v| >= n . v for any |n| <= 1 is sharp where v nearly vanishes.
Interval NormRange(const std::vector<AffineForm>& v)
{
  Interval norm = Sqrt(SquaredNorm(v).Range());
  double length = 0.0;
  for (const AffineForm& component : v)
  {
    length = std::hypot(length, component.a);
  }
  if (length > 0x1p-900)
  {
    AffineForm along;
    for (const AffineForm& component : v)
    {
      along = along + component * AffineForm(component.a / length * (1.0 - 0x1p-40));
    }
    norm.lower = std::max(norm.lower, along.Range().lower);
  }
  return norm;
}

/// The place where the affine parts are smallest, by least squares: a zero of v, up to O(w^2), if
/// the box holds one.
std::array<double, 3> LeastNorm(const std::vector<AffineForm>& v)
{
  Mat3 normal(0.0);
  Vec3 right(0.0);
  for (const AffineForm& component : v)
  {
    const Vec3 b(component.b[0], component.b[1], component.b[2]);
    right -= component.a * b;
    normal += glm::outerProduct(b, b);
  }
  const double trace = normal[0][0] + normal[1][1] + normal[2][2];
  normal += Mat3(trace * 1e-10);
  const Vec3 t = glm::inverse(normal) * right;
  const auto clamped = [](double x) { return x > -1.0 ? std::min(x, 1.0) : -1.0; };
  return { clamped(t.x), clamped(t.y), clamped(t.z) };
}
} // namespace

QuantityFunction::QuantityFunction(const RangeQuestion& question)
  : quantity_(question.quantity)
  , mapping_(question.field && question.quantity != Quantity::Jacobian ? question.field->mapping
                                                                       : Mapping::Identity)
  , Index(static_cast<std::size_t>(
      question.quantity == Quantity::GradientComponent ? question.direction : question.component))
{
}

bool QuantityFunction::IsPlain() const
{
  return quantity_ == Quantity::Component && mapping_ == Mapping::Identity;
}

bool QuantityFunction::IsMagnitude() const
{
  return quantity_ == Quantity::Magnitude || quantity_ == Quantity::GradientMagnitude;
}

bool QuantityFunction::NeedsMap() const
{
  return mapping_ != Mapping::Identity ||
    (quantity_ != Quantity::Component && quantity_ != Quantity::Magnitude);
}

bool QuantityFunction::IsOfZeroField(std::span<const BoxPolynomial> polynomials) const
{
  const bool withMap = NeedsMap() && polynomials.size() > kOfMap;
  return quantity_ != Quantity::Jacobian &&
    std::ranges::all_of(polynomials.subspan(withMap ? kOfMap : 0), &BoxPolynomial::IsZero);
}

void QuantityFunction::ToWorld(std::vector<BoxPolynomial>& polynomials) const
{
  /// The map is constant if its derivatives vary by less than this, relative to their largest
  /// magnitude. Rounding of the conversion is less.
  constexpr double kConstant = 0x1p-40;
  // Converted polynomials are recognised by their number, below kOfMap. Fields with too many
  // components are not converted.
  if (!NeedsMap() || quantity_ == Quantity::Jacobian || polynomials.size() >= 2 * kOfMap)
  {
    return;
  }
  std::vector<Interval> p;
  double largest = 0.0;
  double widest = 0.0;
  for (std::size_t k = 0; k < kOfMap; ++k)
  {
    p.push_back(polynomials[k].Hull());
    largest = std::max(largest, p.back().Magnitude());
    widest = std::max(widest, p.back().Width());
  }
  if (!(widest <= kConstant * largest))
  {
    return;
  }
  const std::span field = std::span(polynomials).subspan(kOfMap);
  // The quantity is linear in the field: its factors are the quantities of the unit vectors.
  p.resize(polynomials.size());
  std::vector<std::vector<Interval>> factors;
  for (std::size_t j = 0; j < field.size(); ++j)
  {
    for (std::size_t k = 0; k < field.size(); ++k)
    {
      p[kOfMap + k] = k == j ? 1.0 : 0.0;
    }
    factors.push_back(Combine<Interval>(p));
    if (!std::ranges::all_of(factors.back(), &Interval::IsFinite))
    {
      return;
    }
  }
  std::vector<BoxPolynomial> world;
  for (std::size_t c = 0; c < factors.front().size(); ++c)
  {
    BoxPolynomial sum{ field[0].degree, std::vector<double>(field[0].b.size(), 0.0), 0.0 };
    for (std::size_t j = 0; j < field.size() && !IsOfZeroField(polynomials); ++j)
    {
      const double middle = factors[j][c].Middle();
      sum = pixelexact::Combine(1.0, sum, middle, field[j]);
      sum.error = rounding::Above(sum.error +
        rounding::Above(factors[j][c].RadiusAround(middle) * field[j].Hull().Magnitude()));
    }
    world.push_back(std::move(sum));
  }
  polynomials = std::move(world);
}

int QuantityFunction::PowerOfLength() const
{
  switch (quantity_)
  {
    case Quantity::Jacobian:
      return 3;
    case Quantity::GradientComponent:
    case Quantity::GradientMagnitude:
      return -1;
    default:
      break;
  }
  switch (mapping_)
  {
    case Mapping::Covariant:
      return -1;
    case Mapping::Contravariant:
      return -2;
    case Mapping::Density:
      return -3;
    default:
      return 0;
  }
}

int QuantityFunction::TellingDifference() const
{
  return IsPlain() ? 2 : 1;
}

template <class T>
std::vector<T> QuantityFunction::Combine(std::span<const T> p) const
{
  if (quantity_ == Quantity::Jacobian)
  {
    return { Determinant(p) };
  }
  const bool gradient =
    quantity_ == Quantity::GradientComponent || quantity_ == Quantity::GradientMagnitude;
  if (!NeedsMap() || p.size() < kOfMap) // as ToWorld leaves them
  {
    return { p.begin(), p.end() };
  }
  const std::span<const T> J = p.first(kOfMap);
  const std::span<const T> v = p.subspan(kOfMap);
  const T inverse = Reciprocal(Determinant(J));
  const auto component = [&](std::size_t k) -> T
  {
    switch (gradient ? Mapping::Covariant : mapping_)
    {
      case Mapping::Covariant:
        return Covariant(J, v, k) * inverse;
      case Mapping::Contravariant:
        return Contravariant(J, v, k) * inverse;
      default:
        return v[k] * inverse;
    }
  };
  if (IsMagnitude())
  {
    std::vector<T> all;
    for (std::size_t k = 0; k < v.size(); ++k)
    {
      all.push_back(component(k));
    }
    return all;
  }
  // A density's polynomials hold the requested component alone.
  return { component(!gradient && mapping_ == Mapping::Density ? 0 : Index) };
}

Interval QuantityFunction::Enclose(std::span<const BoxPolynomial> polynomials) const
{
  if (polynomials.size() == 1 && !IsMagnitude())
  {
    return polynomials[0].Hull();
  }
  const std::vector<AffineForm> v = Combine<AffineForm>(AffineForms(polynomials));
  const Interval range = IsMagnitude() ? NormRange(v) : v[0].Range();
  return range.IsFinite() && IsOfZeroField(polynomials) ? Interval(0.0) : range;
}

Interval QuantityFunction::Value(const std::vector<Interval>& polynomials) const
{
  const std::vector<Interval> v = Combine<Interval>(polynomials);
  return IsMagnitude() ? Sqrt(SquaredNorm(v)) : v[0];
}

Interval QuantityFunction::AtCorner(
  std::span<const BoxPolynomial> polynomials, unsigned corner) const
{
  std::vector<Interval> values;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    values.push_back(polynomial.AtCorner(corner));
  }
  const Interval value = Value(values);
  return value.IsFinite() && IsOfZeroField(polynomials) ? Interval(0.0) : value;
}

PointValue QuantityFunction::AtLikelyMinimum(std::span<const BoxPolynomial> polynomials) const
{
  if (!IsMagnitude())
  {
    return {};
  }
  const auto t = LeastNorm(Combine<AffineForm>(AffineForms(polynomials)));
  std::vector<Interval> values;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    values.push_back(polynomial.At(t));
  }
  return { Value(values), t };
}
} // namespace pixelexact
