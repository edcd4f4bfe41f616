// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/ModeBound.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
double Binomial(int n, int k)
{
  double result = 1.0;
  for (int i = 1; i <= k; ++i)
  {
    result = result * (n - k + i) / i;
  }
  return result;
}

} // namespace

double ModeBound(const Space& space, int p, int q, int r)
{
  // With h = (1 - z) / 2 and P = P_r^{(a,0)}: |P| <= C(r + a, r) (Szego, Orthogonal Polynomials,
  // theorem 7.32.1), and h^{a/2} |P| <= 1, for h^{a/2} P is an element of a unitary matrix
  // (Wigner's d). A factor h^n P with n <= a / 2 is therefore at most min(C h^n, h^{n - a/2}),
  // whose peak is C^{1 - 2 n / a}: an n-th power against one of n - a/2.
  const auto factor = [](int n, int a, int degree)
  { return a == 0 ? 1.0 : std::pow(Binomial(degree + a, degree), 1.0 - 2.0 * n / a); };
  switch (space.shape)
  {
    case Shape::Prism:
      return factor(p, 2 * p + 1, r);
    case Shape::Tetrahedron:
      return factor(p, 2 * p + 1, q) * factor(p + q, 2 * (p + q) + 2, r);
    case Shape::Pyramid:
    {
      const int m = std::max(p, q);
      return space.form == Form::Tensor ? 1.0 : factor(m, 2 * m + 2, r);
    }
    default:
      return 1.0;
  }
}

double SumOfModeBounds(const Space& space)
{
  double sum = 0.0;
  ForEachMode(space, [&](int p, int q, int r, int /*mode*/) { sum += ModeBound(space, p, q, r); });
  return sum;
}
} // namespace pixelexact
