// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bounds/MapCurvature.h"

#include "Core/Bounds/TensorLattice.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Math/Mat.h"
#include "Core/Math/Norm.h"

#include <algorithm>
#include <array>
#include <cmath>
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
} // namespace pixelexact
