// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

// One-dimensional source bases on [-1,1], the factors of tensor-product ones.
namespace pixelexact
{
struct LineFunctions
{
  int count = 0;
  /// Writes the `count` functions' values at z.
  std::function<void(long double z, long double* values)> evaluate;
};

/// n Gauss-Lobatto-Legendre points, ascending, ends included; n >= 2. Accurate to long double.
std::vector<long double> GaussLobattoPoints(int n);
/// n Gauss-Legendre points, ascending; n >= 1. Accurate to long double.
std::vector<long double> GaussPoints(int n);
/// n equispaced points with both ends; one point: the centre.
std::vector<long double> ClosedUniformPoints(int n);

/// Lagrange's polynomials of distinct points.
LineFunctions Lagrange(std::vector<long double> points);
/// Bernstein's polynomials.
LineFunctions Bernstein(int order);
} // namespace pixelexact
