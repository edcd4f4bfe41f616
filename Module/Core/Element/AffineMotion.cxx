// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/AffineMotion.h"

#include <cmath>

namespace pixelexact
{
namespace
{
/// The inverse of a symmetric matrix; none where it is singular up to rounding.
using MotionMatrix = std::array<std::array<long double, 3>, 3>;
std::optional<MotionMatrix> InverseOfSymmetric(const MotionMatrix& m)
{
  MotionMatrix cofactors{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      cofactors[j][i] = m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
        m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
    }
  }
  const long double determinant =
    m[0][0] * cofactors[0][0] + m[0][1] * cofactors[1][0] + m[0][2] * cofactors[2][0];
  if (!(std::fabs(determinant) > 1e-15L * m[0][0] * m[1][1] * m[2][2]))
  {
    return std::nullopt;
  }
  for (auto& row : cofactors)
  {
    for (long double& entry : row)
    {
      entry /= determinant;
    }
  }
  return cofactors;
}
} // namespace

std::array<long double, 3> AffineMotion::Apply(const Vec3& x) const
{
  std::array<long double, 3> image = to;
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      image[c] += matrix[c][j] * (static_cast<long double>(x[static_cast<int>(j)]) - from[j]);
    }
  }
  return image;
}

double AffineMotion::Stretch() const
{
  long double sum = 0.0L;
  for (const auto& row : matrix)
  {
    sum += row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
  }
  return static_cast<double>(std::sqrt(sum));
}

std::optional<AffineMotion> FitMotion(std::span<const Vec3> points, std::span<const Vec3> moved)
{
  AffineMotion motion;
  const auto count = static_cast<long double>(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      motion.from[c] += static_cast<long double>(points[p][static_cast<int>(c)]) / count;
      motion.to[c] += static_cast<long double>(moved[p][static_cast<int>(c)]) / count;
    }
  }
  MotionMatrix spread{};
  MotionMatrix image{};
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    std::array<long double, 3> x{};
    std::array<long double, 3> y{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      x[c] = points[p][static_cast<int>(c)] - motion.from[c];
      y[c] = moved[p][static_cast<int>(c)] - motion.to[c];
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        spread[i][j] += x[i] * x[j];
        image[i][j] += y[i] * x[j];
      }
    }
  }
  const std::optional<MotionMatrix> inverse = InverseOfSymmetric(spread);
  if (!inverse)
  {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        motion.matrix[i][j] += image[i][k] * (*inverse)[k][j];
      }
    }
  }
  return motion;
}
} // namespace pixelexact
