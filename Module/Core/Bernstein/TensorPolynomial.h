// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Math/Interval.h"

#include <array>
#include <cstddef>
#include <span>

// Operations on polynomials in tensor-product Bernstein form over the unit cube of up to three
// parameters t,
//   f(t) = sum b_ijk B_i(t_0) B_j(t_1) B_k(t_2),
// whose coefficients are known up to an error. A direction that is not used has degree 0.
namespace pixelexact
{
using Degrees = std::array<int, 3>;
using Parameters = std::array<double, 3>;
using ParameterIntervals = std::array<Interval, 3>;

/// Degrees above this are refused.
inline constexpr int kMaxDegree = 64;

/// The number of coefficients.
constexpr std::size_t CoefficientCount(const Degrees& degree)
{
  return static_cast<std::size_t>(degree[0] + 1) * static_cast<std::size_t>(degree[1] + 1) *
    static_cast<std::size_t>(degree[2] + 1);
}

/// The distance in memory of coefficients that are neighbours along a direction.
constexpr std::size_t StrideOf(const Degrees& degree, int direction)
{
  std::size_t stride = 1;
  for (int d = 2; d > direction; --d)
  {
    stride *= static_cast<std::size_t>(degree[static_cast<std::size_t>(d)] + 1);
  }
  return stride;
}

/// 0 of none; a NaN makes it NaN.
double LargestMagnitude(std::span<const double> coefficients);

/// Replaces coefficients by those of f over `from` <= t_direction <= `to`, two numbers in [0, 1]
/// (de Casteljau twice). Each coefficient's error grows by at most RestrictionError.
void Restrict(
  const Degrees& degree, int direction, double from, double to, std::span<double> coefficients);

/// Bounds the error that Restrict, or Subdivide, adds to coefficients of at most this magnitude:
/// roundings of two sweeps of convex combinations, and of the second one's parameter, whose error
/// moves the coefficients by their differences.
double RestrictionError(int degree, double magnitude);

/// Coefficients of f in higher degrees, each at least the old one. The error grows by at most
/// ElevationError.
void Elevate(const Degrees& from, const Degrees& to, std::span<const double> coefficients,
  std::span<double> elevated);
double ElevationError(const Degrees& to, double magnitude);

/// f and its gradient at a point, in plain arithmetic.
struct Jet
{
  double value = 0.0;
  Parameters gradient{};
};
Jet EvaluateJet(const Degrees& degree, std::span<const double> coefficients, const Parameters& t);

/// f(t) for every polynomial whose coefficients are within `error` of the given ones; t may lie a
/// little outside of the unit cube.
Interval EncloseValue(
  const Degrees& degree, std::span<const double> coefficients, double error, const Parameters& t);

/// df / dt_direction over the cube [-reach, 1 + reach]^3, for every polynomial whose coefficients
/// are within `error`. The derivative's coefficients are differences of neighbours; beyond the unit
/// cube the Bernstein polynomials of degree n sum in magnitude to at most (1 + 2 reach)^n, so the
/// hull grows about its middle by that.
Interval EncloseDerivative(const Degrees& degree, int direction,
  std::span<const double> coefficients, double error, double reach);

/// The section along a direction where the hull of f meets zero: every root t of f in the unit cube
/// has t_direction in [from, to]. from > to: there is none.
struct Section
{
  double from = 0.0;
  double to = 1.0;
};
Section ClipToZero(
  const Degrees& degree, int direction, std::span<const double> coefficients, double error);
} // namespace pixelexact
