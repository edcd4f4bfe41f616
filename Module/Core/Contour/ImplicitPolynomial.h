// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pixelexact
{
/// z Q z + g z + c.
struct QuadraticPolynomial
{
  /// The coordinates that a coefficient in q belongs to.
  static constexpr std::array<std::array<std::size_t, 2>, 6> kPairs{ { { 0, 0 }, { 1, 1 }, { 2, 2 },
    { 0, 1 }, { 1, 2 }, { 0, 2 } } };

  std::array<double, 6> q{}; ///< of z0^2, z1^2, z2^2, z0 z1, z1 z2, z0 z2
  Vec3 g{ 0.0 };
  double c = 0.0;

  [[nodiscard]] bool IsLinear() const { return q == std::array<double, 6>{}; }
  [[nodiscard]] double At(const Vec3& z) const;
  [[nodiscard]] Vec3 GradientAt(const Vec3& z) const;
  ///@{
  /// Evaluates in an arithmetic with bounds (Interval, ChebyshevModel).
  template <class Number>
  [[nodiscard]] Number At(const std::array<Number, 3>& z) const
  {
    Number sum = c;
    for (std::size_t k = 0; k < kPairs.size(); ++k)
    {
      if (q[k] != 0.0)
      {
        sum = sum + q[k] * (z[kPairs[k][0]] * z[kPairs[k][1]]);
      }
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
      if (g[static_cast<int>(d)] != 0.0)
      {
        sum = sum + g[static_cast<int>(d)] * z[d];
      }
    }
    return sum;
  }
  template <class Number>
  [[nodiscard]] std::array<Number, 3> GradientAt(const std::array<Number, 3>& z) const
  {
    std::array<Number, 3> gradient{ g.x, g.y, g.z };
    for (std::size_t k = 0; k < kPairs.size(); ++k)
    {
      const auto [i, j] = kPairs[k];
      if (q[k] != 0.0)
      {
        gradient[i] = gradient[i] + q[k] * z[j];
        gradient[j] = gradient[j] + q[k] * z[i];
      }
    }
    return gradient;
  }
  ///@}
};

/// The polynomial S whose zeros are a surface, of degree 1 (a plane), 2 (a quadric) or 4 (a torus):
/// S = A(z), or A(z)^2 - B(z), with z = x - origin. An origin near the surface keeps the digits of
/// surfaces far from the world's.
struct ImplicitPolynomial
{
  Vec3 origin{ 0.0 };
  QuadraticPolynomial a;
  std::optional<QuadraticPolynomial> b;

  static ImplicitPolynomial Plane(const Vec3& point, const Vec3& normal);
  static ImplicitPolynomial Sphere(const Vec3& centre, double radius);
  /// A torus about an axis n of length 1 has A = |z|^2 + R^2 - r^2 and
  /// B = 4 R^2 (|z|^2 - (n z)^2). With r > R its tube passes through itself, and the inner part
  /// belongs to it. The axis need not be of unit length. Throws InvalidData when it is zero, a
  /// radius is not positive or a number is not finite.
  static ImplicitPolynomial Torus(const Vec3& centre, const Vec3& axis, double R, double r);

  [[nodiscard]] int Degree() const { return b ? 4 : a.IsLinear() ? 1 : 2; }
  [[nodiscard]] bool IsPlane() const { return Degree() == 1; }
  ///@{
  /// The value and the gradient at x = origin + z.
  [[nodiscard]] double ValueAround(const Vec3& z) const;
  [[nodiscard]] Vec3 GradientAround(const Vec3& z) const;
  template <class Number>
  [[nodiscard]] std::array<Number, 3> GradientAround(const std::array<Number, 3>& z) const
  {
    std::array<Number, 3> gradient = a.GradientAt(z);
    if (b)
    {
      const Number twice = 2.0 * a.At(z);
      const std::array<Number, 3> less = b->GradientAt(z);
      for (std::size_t d = 0; d < 3; ++d)
      {
        gradient[d] = twice * gradient[d] - less[d];
      }
    }
    return gradient;
  }
  ///@}
};

/// A part of a surface: the zeros of a polynomial where no clip is positive.
struct SurfacePatch
{
  ImplicitPolynomial surface;
  std::vector<ImplicitPolynomial> clips{};
  std::optional<Box3> within{}; ///< a box that contains the part; nothing: it may be anywhere
};

/// The faces of a convex body, from the planes of its half-spaces, which are positive outside.
std::vector<SurfacePatch> FacesOfBody(const std::vector<ImplicitPolynomial>& planes);
/// A disc. The normal need not be of unit length.
SurfacePatch DiscPatch(const Vec3& centre, const Vec3& normal, double radius);
/// A triangle, with the product of its first two sides as gradient; nothing where it has no area.
std::optional<SurfacePatch> TrianglePatch(const std::array<Vec3, 3>& corners);
} // namespace pixelexact
