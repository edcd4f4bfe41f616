// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ImplicitPolynomial.h"

#include <span>

namespace pixelexact
{
/// A function whose zeros are a cut-surface.
class CutFunction
{
public:
  virtual ~CutFunction() = default;
  ///@{
  /// At many points.
  virtual void Values(std::span<const Vec3> x, std::span<double> values) const = 0;
  virtual void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const = 0;
  ///@}
  [[nodiscard]] double Value(const Vec3& x) const;
  [[nodiscard]] Vec3 Gradient(const Vec3& x) const;
  /// A polynomial with the same zeros, with which contours are certified. Null: there is none, and
  /// contours are searched for by samples.
  [[nodiscard]] virtual const ImplicitPolynomial* Polynomial() const { return nullptr; }
  /// Whether it must be evaluated on the calling thread.
  [[nodiscard]] virtual bool NeedsCallingThread() const { return false; }
};

/// The zeros of a polynomial. Where S = A^2 - B with A >= 0 its value is A - sqrt(B), which has the
/// same zeros and bends less: of a torus (rho - R)^2 + h^2 - r^2, with the distance rho from the
/// axis and the height h.
class PolynomialCut final : public CutFunction
{
public:
  explicit PolynomialCut(const ImplicitPolynomial& polynomial);
  void Values(std::span<const Vec3> x, std::span<double> values) const override;
  void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override;
  [[nodiscard]] const ImplicitPolynomial* Polynomial() const override { return &Form; }

private:
  ImplicitPolynomial Form;
  bool HasRoot; ///< its value is A - sqrt(B)
};
} // namespace pixelexact
