// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <algorithm>
#include <array>
#include <vector>

// Intersections of lines with surfaces, from the surfaces' definitions in 113 bits.
namespace pixelexact::testing
{
__extension__ using Float128 = __float128;

inline Float128 Size(Float128 x)
{
  return x < 0 ? -x : x;
}

/// A polynomial in a ray's s, of degree up to 4.
struct Polynomial
{
  std::array<Float128, 5> c{};

  Polynomial() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): numbers mix.
  Polynomial(Float128 constant) { c[0] = constant; }

  [[nodiscard]] Float128 At(Float128 s) const
  {
    return (((c[4] * s + c[3]) * s + c[2]) * s + c[1]) * s + c[0];
  }
  [[nodiscard]] Polynomial Derivative() const
  {
    Polynomial result;
    for (std::size_t i = 1; i < 5; ++i)
    {
      result.c[i - 1] = c[i] * static_cast<Float128>(i);
    }
    return result;
  }
  [[nodiscard]] int Degree() const
  {
    int degree = 4;
    while (degree > 0 && c[static_cast<std::size_t>(degree)] == 0)
    {
      --degree;
    }
    return degree;
  }
};
inline Polynomial operator+(Polynomial a, const Polynomial& b)
{
  for (std::size_t i = 0; i < 5; ++i)
  {
    a.c[i] += b.c[i];
  }
  return a;
}
inline Polynomial operator-(Polynomial a, const Polynomial& b)
{
  for (std::size_t i = 0; i < 5; ++i)
  {
    a.c[i] -= b.c[i];
  }
  return a;
}
inline Polynomial operator*(const Polynomial& a, const Polynomial& b)
{
  Polynomial result;
  for (std::size_t i = 0; i < 5; ++i)
  {
    for (std::size_t j = 0; i + j < 5; ++j)
    {
      result.c[i + j] += a.c[i] * b.c[j];
    }
  }
  return result;
}

/// The real roots at which the sign changes, in order, and those of the derivative, between which
/// the polynomial is monotone.
struct RealRoots
{
  std::vector<Float128> roots;
  std::vector<Float128> critical;
};

inline RealRoots RootsOf(const Polynomial& p)
{
  RealRoots result;
  const int degree = p.Degree();
  if (degree == 0)
  {
    return result;
  }
  // Beyond Cauchy's bound there are no roots.
  Float128 bound = 0;
  for (int i = 0; i < degree; ++i)
  {
    bound = std::max(
      bound, Size(p.c[static_cast<std::size_t>(i)] / p.c[static_cast<std::size_t>(degree)]));
  }
  bound += 1;
  result.critical = RootsOf(p.Derivative()).roots;
  std::vector<Float128> ends = result.critical;
  ends.insert(ends.begin(), -bound);
  ends.push_back(bound);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    Float128 low = ends[i];
    Float128 high = ends[i + 1];
    const bool rising = p.At(low) < 0;
    if (!(low < high) || rising == (p.At(high) < 0))
    {
      continue;
    }
    const Polynomial slope = p.Derivative();
    Float128 s = (low + high) / 2;
    for (int step = 0; step < 400 && low < high; ++step)
    {
      const Float128 value = p.At(s);
      ((value < 0) == rising ? low : high) = s;
      Float128 next = s - value / slope.At(s);
      // Bisection now and then: Newton's steps alone may creep.
      if (!(low < next && next < high) || step % 4 == 3)
      {
        next = low + (high - low) / 2;
        if (!(low < next && next < high))
        {
          break;
        }
      }
      if (next == s)
      {
        break;
      }
      s = next;
    }
    result.roots.push_back(s);
  }
  return result;
}

template <class T>
using Point128 = std::array<T, 3>;

/// x less three inputs.
template <class T>
Point128<T> Less(const Point128<T>& x, const Float128* from)
{
  return { x[0] - T(from[0]), x[1] - T(from[1]), x[2] - T(from[2]) };
}
template <class T>
T Square(const Point128<T>& x)
{
  return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}
template <class T>
T DotWith(const Point128<T>& x, const Float128* a)
{
  return x[0] * T(a[0]) + x[1] * T(a[1]) + x[2] * T(a[2]);
}

/// A surface f = 0 by its definition: `f(inputs, x)` of numbers or of polynomials in s. The inputs
/// are the numbers that a user gives.
template <class Function>
struct Definition
{
  std::vector<double> inputs;
  Function f;

  /// How far off, relative to them, the numbers may be that the surface makes of its inputs.
  double preparation = 0x1p-92;

  [[nodiscard]] std::vector<Float128> Values() const { return { inputs.begin(), inputs.end() }; }

  /// f on the ray at t = t0 + s.
  [[nodiscard]] Polynomial Along(const Ray& ray, Float128 t0) const
  {
    std::array<Polynomial, 3> x;
    for (int d = 0; d < 3; ++d)
    {
      x[static_cast<std::size_t>(d)].c[0] = ray.origin[d] + t0 * ray.direction[d];
      x[static_cast<std::size_t>(d)].c[1] = ray.direction[d];
    }
    return f(Values(), x);
  }

  /// The change of f at the ray's t when every number on which it depends changes by its own size.
  [[nodiscard]] Float128 Sensitivity(const Ray& ray, Float128 t) const
  {
    std::vector<Float128> values = Values();
    std::array<Float128, 3> x;
    for (int d = 0; d < 3; ++d)
    {
      x[static_cast<std::size_t>(d)] = ray.origin[d] + t * ray.direction[d];
    }
    // Central differences, because f is nearly quadratic over such a step.
    const auto change = [&](Float128& number, Float128 size) -> Float128
    {
      const Float128 kept = number;
      const Float128 h = size * static_cast<Float128>(1e-11);
      number = kept + h;
      const Float128 above = f(values, x);
      number = kept - h;
      const Float128 below = f(values, x);
      number = kept;
      return Size(above - below) / static_cast<Float128>(2e-11);
    };
    Float128 sum = 0;
    for (Float128& value : values)
    {
      sum += change(value, Size(value));
    }
    for (int d = 0; d < 3; ++d)
    {
      sum += change(x[static_cast<std::size_t>(d)],
        Size(ray.origin[d]) + Size(t * static_cast<Float128>(ray.direction[d])));
    }
    return sum;
  }
};
template <class Function>
Definition(std::vector<double>, Function) -> Definition<Function>;
template <class Function>
Definition(std::vector<double>, Function, double) -> Definition<Function>;
} // namespace pixelexact::testing
