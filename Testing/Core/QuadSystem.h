// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/PolynomialSystem.h"

#include <array>
#include <optional>
#include <vector>

// Polynomials in 113 bits, as an oracle for the root engine: made from known roots, evaluated and
// solved without any of its code.
namespace pixelexact::testing
{
__extension__ typedef __float128 Float128;
using QuadPoint = std::array<Float128, 3>;

inline Float128 Magnitude(Float128 v)
{
  return v < 0 ? -v : v;
}

/// Tensor-product power basis: c[i][j][k] t0^i t1^j t2^k.
struct QuadPolynomial
{
  Degrees degree{};
  std::vector<Float128> power;

  static QuadPolynomial Constant(Float128 value) { return { {}, { value } }; }
  static QuadPolynomial Variable(int direction)
  {
    QuadPolynomial t;
    t.degree[static_cast<std::size_t>(direction)] = 1;
    t.power = { Float128(0), Float128(1) };
    return t;
  }

  [[nodiscard]] Float128 At(int i, int j, int k) const
  {
    return i <= degree[0] && j <= degree[1] && k <= degree[2]
      ? power[static_cast<std::size_t>((i * (degree[1] + 1) + j) * (degree[2] + 1) + k)]
      : Float128(0);
  }

  [[nodiscard]] Float128 Value(const QuadPoint& t) const
  {
    Float128 sum0 = 0;
    for (int i = degree[0]; i >= 0; --i)
    {
      Float128 sum1 = 0;
      for (int j = degree[1]; j >= 0; --j)
      {
        Float128 sum2 = 0;
        for (int k = degree[2]; k >= 0; --k)
        {
          sum2 = sum2 * t[2] + At(i, j, k);
        }
        sum1 = sum1 * t[1] + sum2;
      }
      sum0 = sum0 * t[0] + sum1;
    }
    return sum0;
  }

  [[nodiscard]] QuadPolynomial Derivative(int direction) const
  {
    QuadPolynomial result;
    result.degree = degree;
    auto& n = result.degree[static_cast<std::size_t>(direction)];
    n = std::max(0, n - 1);
    for (int i = 0; i <= result.degree[0]; ++i)
    {
      for (int j = 0; j <= result.degree[1]; ++j)
      {
        for (int k = 0; k <= result.degree[2]; ++k)
        {
          const std::array<int, 3> at{ i + (direction == 0), j + (direction == 1),
            k + (direction == 2) };
          result.power.push_back(
            Float128(at[static_cast<std::size_t>(direction)]) * At(at[0], at[1], at[2]));
        }
      }
    }
    return result;
  }

  /// The Bernstein form over the unit cube, rounded to double. Its error is that rounding.
  [[nodiscard]] TensorPolynomial Rounded() const
  {
    const auto binomial = [](int n, int k)
    {
      Float128 result = 1;
      for (int i = 1; i <= k; ++i)
      {
        result = result * (n - k + i) / i;
      }
      return result;
    };
    std::vector<Float128> b = power;
    std::size_t stride = 1;
    for (int d = 2; d >= 0; --d)
    {
      const int n = degree[static_cast<std::size_t>(d)];
      const auto count = static_cast<std::size_t>(n + 1);
      for (std::size_t start = 0; start < b.size(); start += stride * count)
      {
        for (std::size_t inner = 0; inner < stride; ++inner)
        {
          std::vector<Float128> line;
          for (int j = 0; j <= n; ++j)
          {
            Float128 sum = 0;
            for (int i = 0; i <= j; ++i)
            {
              sum += binomial(j, i) / binomial(n, i) *
                b[start + inner + static_cast<std::size_t>(i) * stride];
            }
            line.push_back(sum);
          }
          for (std::size_t j = 0; j < count; ++j)
          {
            b[start + inner + j * stride] = line[j];
          }
        }
      }
      stride *= count;
    }
    TensorPolynomial result{ degree, {}, 0.0 };
    for (const Float128 v : b)
    {
      result.coefficients.push_back(static_cast<double>(v));
      const Float128 off = Magnitude(v - Float128(result.coefficients.back()));
      result.error = std::max(result.error, static_cast<double>(off) * (1.0 + 1e-10));
    }
    return result;
  }
};

inline QuadPolynomial operator+(const QuadPolynomial& a, const QuadPolynomial& b)
{
  QuadPolynomial sum;
  for (std::size_t d = 0; d < 3; ++d)
  {
    sum.degree[d] = std::max(a.degree[d], b.degree[d]);
  }
  for (int i = 0; i <= sum.degree[0]; ++i)
  {
    for (int j = 0; j <= sum.degree[1]; ++j)
    {
      for (int k = 0; k <= sum.degree[2]; ++k)
      {
        sum.power.push_back(a.At(i, j, k) + b.At(i, j, k));
      }
    }
  }
  return sum;
}

inline QuadPolynomial operator*(const QuadPolynomial& a, const QuadPolynomial& b)
{
  QuadPolynomial product;
  for (std::size_t d = 0; d < 3; ++d)
  {
    product.degree[d] = a.degree[d] + b.degree[d];
  }
  product.power.assign(CoefficientCount(product.degree), Float128(0));
  for (int i = 0; i <= product.degree[0]; ++i)
  {
    for (int j = 0; j <= product.degree[1]; ++j)
    {
      for (int k = 0; k <= product.degree[2]; ++k)
      {
        Float128 sum = 0;
        for (int p = 0; p <= std::min(i, a.degree[0]); ++p)
        {
          for (int q = 0; q <= std::min(j, a.degree[1]); ++q)
          {
            for (int r = 0; r <= std::min(k, a.degree[2]); ++r)
            {
              sum += a.At(p, q, r) * b.At(i - p, j - q, k - r);
            }
          }
        }
        product.power[static_cast<std::size_t>(
          (i * (product.degree[1] + 1) + j) * (product.degree[2] + 1) + k)] = sum;
      }
    }
  }
  return product;
}

/// A system f_k = 0 with the same number of polynomials and variables.
class QuadSystem
{
public:
  explicit QuadSystem(std::vector<QuadPolynomial> polynomials)
    : Polynomials(std::move(polynomials))
  {
    for (const auto& f : Polynomials)
    {
      for (int d = 0; d < Size(); ++d)
      {
        Derivatives.push_back(f.Derivative(d));
      }
    }
  }

  [[nodiscard]] int Size() const { return static_cast<int>(Polynomials.size()); }

  [[nodiscard]] PolynomialSystem Rounded(double moreError = 0.0) const
  {
    std::vector<TensorPolynomial> rounded;
    for (const auto& f : Polynomials)
    {
      rounded.push_back(f.Rounded());
      rounded.back().error += moreError;
    }
    return { Size(), rounded };
  }

  /// Newton's iteration; nothing where it does not converge to 30 digits.
  [[nodiscard]] std::optional<QuadPoint> Newton(QuadPoint t) const
  {
    const auto n = static_cast<std::size_t>(Size());
    for (int step = 0; step < 60; ++step)
    {
      std::array<std::array<Float128, 4>, 3> a{};
      for (std::size_t k = 0; k < n; ++k)
      {
        for (std::size_t d = 0; d < n; ++d)
        {
          a[k][d] = Derivatives[k * n + d].Value(t);
        }
        a[k][n] = Polynomials[k].Value(t);
      }
      for (std::size_t c = 0; c < n; ++c)
      {
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < n; ++r)
        {
          pivot = Magnitude(a[r][c]) > Magnitude(a[pivot][c]) ? r : pivot;
        }
        std::swap(a[pivot], a[c]);
        if (a[c][c] == 0)
        {
          return std::nullopt;
        }
        for (std::size_t r = 0; r < n; ++r)
        {
          const Float128 factor = r == c ? Float128(0) : a[r][c] / a[c][c];
          for (std::size_t d = c; d <= n; ++d)
          {
            a[r][d] -= factor * a[c][d];
          }
        }
      }
      Float128 longest = 0;
      for (std::size_t d = 0; d < n; ++d)
      {
        const Float128 delta = a[d][n] / a[d][d];
        t[d] -= delta;
        longest = std::max(longest, Magnitude(delta));
        if (!(Magnitude(t[d]) < 10))
        {
          return std::nullopt;
        }
      }
      if (longest < Float128(1e-30))
      {
        return t;
      }
    }
    return std::nullopt;
  }

private:
  std::vector<QuadPolynomial> Polynomials;
  std::vector<QuadPolynomial> Derivatives; ///< [k * size + d]
};
} // namespace pixelexact::testing
