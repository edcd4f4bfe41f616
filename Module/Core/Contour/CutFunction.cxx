// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/CutFunction.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
double CutFunction::Value(const Vec3& x) const
{
  double value = 0.0;
  Values({ &x, 1 }, { &value, 1 });
  return value;
}

Vec3 CutFunction::Gradient(const Vec3& x) const
{
  Vec3 gradient;
  Gradients({ &x, 1 }, { &gradient, 1 });
  return gradient;
}

// A of a torus is |z|^2 + c.
PolynomialCut::PolynomialCut(const ImplicitPolynomial& polynomial)
  : Form(polynomial)
  , HasRoot(polynomial.b && polynomial.a.c >= 0.0)
{
}

void PolynomialCut::Values(std::span<const Vec3> x, std::span<double> values) const
{
  std::ranges::transform(x, values.begin(),
    [this](const Vec3& at)
    {
      const Vec3 z = at - Form.origin;
      return HasRoot ? Form.a.At(z) - std::sqrt(std::max(0.0, Form.b->At(z))) : Form.ValueAround(z);
    });
}

void PolynomialCut::Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const
{
  std::ranges::transform(x, gradients.begin(),
    [this](const Vec3& at)
    {
      const Vec3 z = at - Form.origin;
      if (!HasRoot)
      {
        return Form.GradientAround(z);
      }
      // On the axis the direction across it is undefined.
      const double root = std::sqrt(std::max(0.0, Form.b->At(z)));
      const Vec3 gradient = Form.a.GradientAt(z);
      return root > 0.0 ? gradient - Form.b->GradientAt(z) / (2.0 * root) : gradient;
    });
}
} // namespace pixelexact
