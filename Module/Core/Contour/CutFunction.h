// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <array>
#include <span>

namespace pixelexact
{
/// z Q z + g z + c with z = x - origin: a plane, a sphere, any quadric. Its origin near the surface
/// keeps the digits of surfaces far from the world's.
struct QuadricForm
{
  Vec3 origin{ 0.0 };
  std::array<double, 6> q{}; ///< of z0^2, z1^2, z2^2, z0 z1, z1 z2, z0 z2
  Vec3 g{ 0.0 };
  double c = 0.0;

  [[nodiscard]] bool IsPlane() const { return q == std::array<double, 6>{}; }
  /// At x = origin + z.
  [[nodiscard]] double ValueAround(const Vec3& z) const;
  [[nodiscard]] Vec3 GradientAround(const Vec3& z) const;
};

/// A(z)^2 - B(z) with two quadrics of the same origin: a torus about an axis n of length 1 has
/// A = |z|^2 + R^2 - r^2 and B = 4 R^2 (|z|^2 - (n z)^2). With r > R its tube passes through
/// itself, and the inner part belongs to it.
struct QuarticForm
{
  QuadricForm a;
  QuadricForm b;

  /// The axis need not be of unit length. Throws InvalidData when it is zero, a radius is not
  /// positive or a number is not finite.
  static QuarticForm Torus(const Vec3& centre, const Vec3& axis, double R, double r);
  /// At x = origin + z.
  [[nodiscard]] double ValueAround(const Vec3& z) const;
  [[nodiscard]] Vec3 GradientAround(const Vec3& z) const;
};

/// The function S whose zeros are a cut-surface.
class CutFunction
{
public:
  virtual ~CutFunction() = default;
  [[nodiscard]] virtual double Value(const Vec3& x) const = 0;
  [[nodiscard]] virtual Vec3 Gradient(const Vec3& x) const = 0;
  ///@{
  /// At many points, for functions that are asked faster so.
  virtual void Values(std::span<const Vec3> x, std::span<double> values) const;
  virtual void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const;
  ///@}
  ///@{
  /// A polynomial with the zeros of the function, with which contours can be certified. Where both
  /// are null, contours are searched for by samples.
  [[nodiscard]] virtual const QuadricForm* Quadric() const { return nullptr; }
  [[nodiscard]] virtual const QuarticForm* Quartic() const { return nullptr; }
  [[nodiscard]] bool IsPolynomial() const { return Quadric() != nullptr || Quartic() != nullptr; }
  ///@}
  /// Whether it may be asked by one thread alone.
  [[nodiscard]] virtual bool NeedsCallingThread() const { return false; }
};

class QuadricCut final : public CutFunction
{
public:
  explicit QuadricCut(const QuadricForm& form)
    : Form(form)
  {
  }
  [[nodiscard]] double Value(const Vec3& x) const override
  {
    return Form.ValueAround(x - Form.origin);
  }
  [[nodiscard]] Vec3 Gradient(const Vec3& x) const override
  {
    return Form.GradientAround(x - Form.origin);
  }
  [[nodiscard]] const QuadricForm* Quadric() const override { return &Form; }

private:
  QuadricForm Form;
};

/// A torus. With r <= R its function is (rho - R)^2 + h^2 - r^2, with the distance rho from the
/// axis and the height h: that of vtkImplicitTorus. With r > R it is the quartic.
class TorusCut final : public CutFunction
{
public:
  /// As QuarticForm::Torus.
  TorusCut(const Vec3& centre, const Vec3& axis, double R, double r);
  [[nodiscard]] double Value(const Vec3& x) const override;
  [[nodiscard]] Vec3 Gradient(const Vec3& x) const override;
  [[nodiscard]] const QuarticForm* Quartic() const override { return &Form; }

private:
  QuarticForm Form;
  Vec3 Axis; ///< of unit length
  double CircleRadius;
  double TubeRadius;
};
} // namespace pixelexact
