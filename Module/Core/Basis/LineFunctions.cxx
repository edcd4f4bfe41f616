// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/LineFunctions.h"

#include "Core/Base/Error.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr int kNewtonSteps = 64;

/// Legendre's polynomial of degree n and its derivative at z, |z| < 1.
std::pair<long double, long double> Legendre(int n, long double z)
{
  long double previous = 1.0L;
  long double current = z;
  if (n == 0)
  {
    return { 1.0L, 0.0L };
  }
  for (int k = 2; k <= n; ++k)
  {
    const long double next = ((2 * k - 1) * z * current - (k - 1) * previous) / k;
    previous = current;
    current = next;
  }
  return { current, n * (previous - z * current) / (1 - z * z) };
}

/// Newton's iteration until the step is lost in rounding.
template <class Step>
long double Refine(long double z, Step&& step)
{
  for (int k = 0; k < kNewtonSteps; ++k)
  {
    const long double correction = step(z);
    z -= correction;
    if (std::fabs(correction) <= std::numeric_limits<long double>::epsilon())
    {
      break;
    }
  }
  return z;
}

void RequirePoints(int n, int least)
{
  if (n < least)
  {
    throw Error("a rule of at least " + std::to_string(least) + " points is needed, not of " +
      std::to_string(n) + ".");
  }
}

/// Mirrors the lower half, so that the points are symmetric to the last bit.
void MakeSymmetric(std::vector<long double>& points)
{
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n / 2; ++i)
  {
    points[n - 1 - i] = -points[i];
  }
  if (n % 2 == 1)
  {
    points[n / 2] = 0.0L;
  }
}
} // namespace

std::vector<long double> GaussLobattoPoints(int n)
{
  RequirePoints(n, 2);
  const int degree = n - 1;
  std::vector<long double> points(n);
  points.front() = -1.0L;
  for (int i = 1; i < n / 2; ++i)
  {
    // The roots of P'. By Legendre's equation (1 - z^2) P'' = 2 z P' - N (N + 1) P.
    points[i] = Refine(-std::cos(std::numbers::pi_v<long double> * i / degree),
      [degree](long double z)
      {
        const auto [p, dp] = Legendre(degree, z);
        return dp * (1 - z * z) / (2 * z * dp - degree * (degree + 1) * p);
      });
  }
  MakeSymmetric(points);
  return points;
}

std::vector<long double> GaussPoints(int n)
{
  RequirePoints(n, 1);
  std::vector<long double> points(n);
  for (int i = 0; i < n / 2; ++i)
  {
    points[i] = Refine(-std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L)),
      [n](long double z)
      {
        const auto [p, dp] = Legendre(n, z);
        return p / dp;
      });
  }
  MakeSymmetric(points);
  return points;
}

std::vector<long double> ClosedUniformPoints(int n)
{
  RequirePoints(n, 1);
  std::vector<long double> points(n, 0.0L);
  for (int i = 0; i < n && n > 1; ++i)
  {
    points[i] = 2.0L * i / (n - 1) - 1.0L;
  }
  return points;
}

LineFunctions Lagrange(std::vector<long double> points)
{
  const int n = static_cast<int>(points.size());
  std::vector<long double> weights(n, 1.0L);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      weights[i] *= i == j ? 1.0L : points[i] - points[j];
    }
  }
  const auto evaluate = [points = std::move(points), weights = std::move(weights)](
                          long double z, long double* values)
  {
    // The product form: exact at the points, without a division by z - z_i.
    const std::size_t count = points.size();
    long double below = 1.0L;
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] = below / weights[i];
      below *= z - points[i];
    }
    long double above = 1.0L;
    for (std::size_t i = count; i-- > 0;)
    {
      values[i] *= above;
      above *= z - points[i];
    }
  };
  return { n, evaluate };
}

LineFunctions Bernstein(int order)
{
  const auto evaluate = [order](long double z, long double* values)
  {
    const long double a = (1 + z) / 2;
    const long double b = (1 - z) / 2;
    // Degree by degree, as in de Casteljau's scheme: only sums of products of a and b.
    values[0] = 1.0L;
    for (int n = 1; n <= order; ++n)
    {
      values[n] = a * values[n - 1];
      for (int k = n - 1; k > 0; --k)
      {
        values[k] = b * values[k] + a * values[k - 1];
      }
      values[0] *= b;
    }
  };
  return { order + 1, evaluate };
}
} // namespace pixelexact
