// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bounds/MapCurvature.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Bounds/TensorLattice.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Math/Mat.h"
#include "Core/Math/Norm.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace pixelexact
{
namespace
{
/// The number of Chebyshev points along each eta.
constexpr int kCurvaturePoints = 4;
constexpr double kSafety = 2.0;
/// Below this curvature, Newton's iteration takes the smallest number of steps.
constexpr double kMin = 1e-3;

std::vector<Vec3> LatticeOf(Shape shape)
{
  std::array<double, kCurvaturePoints> eta{};
  for (int i = 0; i < kCurvaturePoints; ++i)
  {
    eta[static_cast<std::size_t>(i)] = ChebyshevPoint(i, kCurvaturePoints);
  }
  return TensorLattice(shape, eta);
}

/// The matrix norm induced by the max norm. GLM's matrices are stored by columns.
double RowSumNorm(const Mat3& m)
{
  double norm = 0.0;
  for (int row = 0; row < 3; ++row)
  {
    norm = std::max(norm, std::fabs(m[0][row]) + std::fabs(m[1][row]) + std::fabs(m[2][row]));
  }
  return norm;
}

/// The unit of length at two points: for a pyramid the lesser of 1 and the distance to the apex.
double UnitAt(Shape shape, const Vec3& a, const Vec3& b)
{
  return shape == Shape::Pyramid ? std::min(1.0, 0.5 * (1.0 - std::max(a.z, b.z))) : 1.0;
}

std::vector<Mat3> JacobiansAt(
  const Space& space, const double* coefficients, const std::vector<Vec3>& xi)
{
  const LaneBuffer at(xi);
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  std::vector<double> lanes(12 * stride);
  double* arrays[12];
  for (std::size_t k = 0; k < 12; ++k)
  {
    arrays[k] = &lanes[k * stride];
  }
  KernelsFor(space).gradient(space, coefficients, 3, at.View(), arrays, arrays + 3);
  std::vector<Mat3> jacobians(xi.size());
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int d = 0; d < 3; ++d)
      {
        jacobians[k][d][c] = arrays[3 + 3 * c + d][k];
      }
    }
  }
  return jacobians;
}
} // namespace

double MapCurvature(const Space& space, const double* coefficients)
{
  const std::vector<Vec3> xi = LatticeOf(space.shape);
  const std::vector<Mat3> jacobians = JacobiansAt(space, coefficients, xi);
  std::size_t step = 1;
  double sum = 0.0;
  for (int axis = 2; axis >= 0; --axis, step *= kCurvaturePoints)
  {
    double largest = 0.0;
    for (std::size_t a = 0; a < xi.size(); ++a)
    {
      if (a / step % kCurvaturePoints == kCurvaturePoints - 1)
      {
        continue;
      }
      const std::size_t b = a + step;
      const Mat3 change = glm::inverse(jacobians[a]) * (jacobians[b] - jacobians[a]);
      const double bend =
        RowSumNorm(change) / MaxAbs(xi[b] - xi[a]) * UnitAt(space.shape, xi[a], xi[b]);
      if (!std::isfinite(bend))
      {
        return kUnknownCurvature;
      }
      largest = std::max(largest, bend);
    }
    sum += largest;
  }
  return std::max(kMin, kSafety * sum);
}

namespace
{
/// Bounds the second derivatives of a pyramid's mode f, times the distance h = (1 - eta3) / 2 to
/// the apex. A derivative by xi is at most 1 / h times the sum of those by eta, each at most its
/// degree squared times the largest value (A. Markov), and |f| <= C(r + 2 m + 2, r) h^m
/// (ModeBound.cxx).
double SecondDerivativeBoundOfPyramid(int p, int q, int r)
{
  const int m = std::max(p, q);
  const double first = p * p + q * q + (m + r) * (m + r);
  double largest = 1.0;
  for (int i = 1; i <= r; ++i)
  {
    largest = largest * (2 * m + 2 + i) / i;
  }
  return 9.0 * first * (first + 1.5) * largest;
}

/// The same for the mode P_p(eta1) P_q(eta2) P_r(eta3) of a pyramid, times h^2: by the chain rule,
/// with d eta_i / d xi_i = 1 / h, d eta_i / d xi_3 = (1 + eta_i) / 2 h <= 1 / h for i = 1, 2, and h
/// <= 1.
double SecondDerivativeBoundOfTensorPyramid(int p, int q, int r)
{
  const auto first = [](double n) { return n * (n + 1.0) / 2.0; };
  const auto second = [](double n) { return (n - 1.0) * n * (n + 1.0) * (n + 2.0) / 8.0; };
  return 4.0 * (second(p) + second(q)) + second(r) + 8.0 * first(p) * first(q) +
    (first(p) + first(q)) * (4.0 * first(r) + 2.0);
}

/// Bounds the sum of the second derivatives' magnitudes over the shape, for a mode of magnitude at
/// most 1. Legendre polynomials have their largest derivatives at the ends. In a convex body of
/// least width w a polynomial of degree n and magnitude 1 has gradients of at most 4 n^2 / w (D.
/// Wilhelmsen, A Markov inequality in several dimensions, J. Approx. Theory 11, 1974); w is sqrt(2)
/// for the triangle, 2 / sqrt(3) for the tetrahedron.
double SecondDerivativeBound(Shape shape, int p, int q, int r)
{
  const auto first = [](double n) { return n * (n + 1.0) / 2.0; };
  const auto second = [](double n) { return (n - 1.0) * n * (n + 1.0) * (n + 2.0) / 8.0; };
  const auto square = [](double n) { return n * n; };
  switch (shape)
  {
    case Shape::Hexahedron:
      return second(p) + second(q) + second(r) +
        2.0 * (first(p) * first(q) + first(q) * first(r) + first(p) * first(r));
    case Shape::Prism:
    {
      const double n = p + r;
      return 22.7 * square(n) * square(n - 1.0) + 8.0 * square(n) * first(q) + second(q);
    }
    case Shape::Tetrahedron:
    {
      const double n = p + q + r;
      return 62.4 * square(n) * square(n - 1.0);
    }
    default:
      return std::numeric_limits<double>::infinity();
  }
}

/// Bounds the growth of the space's polynomials over 6e-3 outside the shape by Chebyshev
/// polynomials. For a pyramid the distance is 6e-3 h, twice as much in eta1 and eta2, and 1 / h
/// grows as well.
double GrowthBeside(const Space& space)
{
  const auto [P, Q, R] = space.order;
  if (space.form == Form::Tensor)
  {
    return std::exp(0.16 * (P + Q + R) + 0.02);
  }
  return space.shape == Shape::Hexahedron ? std::exp(0.11 * (P + Q + R)) : std::exp(0.29 * (Q + R));
}

/// Bounds InverseProblem::bend per unit of each mode's coefficient.
std::vector<double> BendBounds(const Space& space)
{
  std::vector<double> bounds;
  bounds.reserve(static_cast<std::size_t>(space.Modes()));
  const double growth = GrowthBeside(space);
  ForEachMode(space,
    [&](int p, int q, int r, int /*mode*/)
    {
      bounds.push_back(growth *
        (space.form == Form::Tensor ? SecondDerivativeBoundOfTensorPyramid(p, q, r)
            : space.shape == Shape::Pyramid
            ? SecondDerivativeBoundOfPyramid(p, q, r)
            : ModeBound(space, p, q, r) * SecondDerivativeBound(space.shape, p, q, r)));
    });
  return bounds;
}

/// The same, computed once per space and kept by each thread.
const std::vector<double>& BendBoundsOf(const Space& space)
{
  thread_local std::map<Space, std::vector<double>> kept;
  std::vector<double>& bounds = kept[space];
  if (bounds.empty())
  {
    bounds = BendBounds(space);
  }
  return bounds;
}
} // namespace

double MapBend(const Space& space, const double* coefficients)
{
  const auto& bounds = BendBoundsOf(space);
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double* component = coefficients + c * bounds.size();
    double sum = 0.0;
    for (std::size_t mode = 1; mode < bounds.size(); ++mode)
    {
      sum += std::fabs(component[mode]) * bounds[mode];
    }
    largest = std::max(largest, sum);
  }
  return largest * (1.0 + Gamma(static_cast<int>(bounds.size()) + 64));
}
} // namespace pixelexact
