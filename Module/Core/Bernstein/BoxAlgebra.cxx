// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/BoxAlgebra.h"

#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Binomial coefficients of a degree, each off by at most `degree` roundings of products and as
/// many of quotients.
std::vector<double> Binomials(int degree)
{
  std::vector<double> row{ 1.0 };
  for (int i = 1; i <= degree; ++i)
  {
    row.push_back(row.back() * (degree + 1 - i) / i);
  }
  return row;
}

struct Weights
{
  explicit Weights(const Degrees& degree)
    : row{ Binomials(degree[0]), Binomials(degree[1]), Binomials(degree[2]) }
  {
  }
  [[nodiscard]] double At(std::size_t i, std::size_t j, std::size_t k) const
  {
    return row[0][i] * row[1][j] * row[2][k];
  }
  std::array<std::vector<double>, 3> row;
};

/// Calls visit(i, j, k, index) for each coefficient.
template <class Visit>
void ForEachCoefficient(const Degrees& degree, Visit&& visit)
{
  std::size_t index = 0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(degree[0]); ++i)
  {
    for (std::size_t j = 0; j <= static_cast<std::size_t>(degree[1]); ++j)
    {
      for (std::size_t k = 0; k <= static_cast<std::size_t>(degree[2]); ++k)
      {
        visit(i, j, k, index++);
      }
    }
  }
}

std::vector<double> Weighted(const BoxPolynomial& f)
{
  const Weights weights(f.degree);
  std::vector<double> result(f.b.size());
  ForEachCoefficient(f.degree,
    [&](std::size_t i, std::size_t j, std::size_t k, std::size_t at)
    { result[at] = weights.At(i, j, k) * f.b[at]; });
  return result;
}

BoxPolynomial Raised(const BoxPolynomial& f, const Degrees& degree)
{
  BoxPolynomial raised{ degree, std::vector<double>(CoefficientCount(degree)), 0.0 };
  Elevate(f.degree, degree, f.b, raised.b);
  raised.error = f.error + ElevationError(degree, LargestMagnitude(f.b));
  return raised;
}
} // namespace

BoxPolynomial Multiply(const BoxPolynomial& f, const BoxPolynomial& g)
{
  BoxPolynomial product;
  int roundings = 16;
  int terms = 1;
  for (std::size_t d = 0; d < 3; ++d)
  {
    product.degree[d] = f.degree[d] + g.degree[d];
    roundings += 4 * product.degree[d];
    terms *= std::min(f.degree[d], g.degree[d]) + 1;
  }
  product.b.assign(CoefficientCount(product.degree), 0.0);
  const std::vector<double> left = Weighted(f);
  const std::vector<double> right = Weighted(g);
  const std::size_t row = StrideOf(product.degree, 1);
  const std::size_t plane = StrideOf(product.degree, 0);
  const std::size_t length = StrideOf(g.degree, 1);
  ForEachCoefficient(f.degree,
    [&](std::size_t i, std::size_t j, std::size_t k, std::size_t at)
    {
      const double factor = left[at];
      const double* from = right.data();
      for (std::size_t p = 0; p <= static_cast<std::size_t>(g.degree[0]); ++p)
      {
        for (std::size_t q = 0; q <= static_cast<std::size_t>(g.degree[1]); ++q, from += length)
        {
          double* to = &product.b[(i + p) * plane + (j + q) * row + k];
          for (std::size_t r = 0; r < length; ++r)
          {
            to[r] += factor * from[r];
          }
        }
      }
    });
  const Weights weights(product.degree);
  ForEachCoefficient(product.degree,
    [&](std::size_t i, std::size_t j, std::size_t k, std::size_t at)
    { product.b[at] /= weights.At(i, j, k); });
  // Each coefficient is a mean of products f_i g_j, with weights that sum to 1.
  const double f1 = LargestMagnitude(f.b);
  const double g1 = LargestMagnitude(g.b);
  product.error =
    (Gamma(roundings + terms) * f1 * g1 + f1 * g.error + g1 * f.error + f.error * g.error) *
      (1.0 + Gamma(16)) +
    0x1p-1000;
  return product;
}

BoxPolynomial Combine(double a, const BoxPolynomial& f, double b, const BoxPolynomial& g)
{
  BoxPolynomial sum{ f.degree, std::vector<double>(f.b.size()), 0.0 };
  for (std::size_t i = 0; i < sum.b.size(); ++i)
  {
    sum.b[i] = a * f.b[i] + b * g.b[i];
  }
  sum.error = (std::fabs(a) * (f.error + Gamma(3) * LargestMagnitude(f.b)) +
                std::fabs(b) * (g.error + Gamma(3) * LargestMagnitude(g.b))) *
      (1.0 + Gamma(16)) +
    0x1p-1000;
  return sum;
}

BoxPolynomial Sum(const BoxPolynomial& f, const BoxPolynomial& g)
{
  Degrees degree;
  std::ranges::transform(
    f.degree, g.degree, degree.begin(), [](int a, int b) { return std::max(a, b); });
  return Combine(1.0, Raised(f, degree), 1.0, Raised(g, degree));
}

BoxPolynomial Derivative(const BoxPolynomial& f, int direction)
{
  const int n = f.degree[static_cast<std::size_t>(direction)];
  const std::size_t stride = StrideOf(f.degree, direction);
  BoxPolynomial slope{ f.degree, std::vector<double>(f.b.size()), 0.0 };
  for (std::size_t at = 0; at < f.b.size(); ++at)
  {
    // The derivative of degree n - 1, raised to n.
    const auto i = static_cast<int>(at / stride % static_cast<std::size_t>(n + 1));
    const double before = i > 0 ? i * (f.b[at] - f.b[at - stride]) : 0.0;
    const double after = i < n ? (n - i) * (f.b[at + stride] - f.b[at]) : 0.0;
    slope.b[at] = before + after;
  }
  slope.error =
    2.0 * n * (f.error + Gamma(4) * LargestMagnitude(f.b)) * (1.0 + Gamma(16)) + 0x1p-1000;
  return slope;
}

void Add(const Interval& c, BoxPolynomial& f)
{
  const double middle = c.Middle();
  double largest = 0.0;
  for (double& b : f.b)
  {
    b += middle;
    largest = std::max(largest, std::fabs(b));
  }
  f.error = (f.error + c.RadiusAround(middle) + Gamma(1) * largest) * (1.0 + Gamma(8)) + 0x1p-1000;
}
} // namespace pixelexact
