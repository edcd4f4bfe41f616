// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/LocalCurves.h"

#include "Core/Math/Mat.h"
#include "Core/Questions/EdgeArithmetic.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
double At(const AffineBound& bound, const Vec3& x)
{
  return bound.value + bound.slope[0] * x.x + bound.slope[1] * x.y + bound.slope[2] * x.z;
}

/// The largest row sum of the residual of an inverse.
constexpr double kMaxOff = 1e-3;

double MagnitudeOf(const double (&form)[6], const double (&away)[3])
{
  double magnitudes[6];
  std::ranges::transform(form, magnitudes, [](double m) { return std::fabs(m); });
  return edges::Quadratic(magnitudes, away);
}

/// The factor 1/3 is the integral of 2 (1 - t) t over [0, 1].
double Beside(const AffineBound& bound, const std::array<double, 3>& away)
{
  return (bound.radius +
           (std::fabs(bound.slope[0]) * away[0] + std::fabs(bound.slope[1]) * away[1] +
             std::fabs(bound.slope[2]) * away[2]) /
             3.0) *
    edges::kUp;
}
} // namespace

LocalCurves::LocalCurves(const EdgeNode& node, const Vec3& at)
  : Slopes(*node.slopes)
{
  const Vec3 x = at - node.centre;
  for (std::size_t p = 0; p < 6; ++p)
  {
    curve[p] = At(Slopes.curve[p], x);
    for (std::size_t k = 0; k < 3; ++k)
    {
      bend[k][p] = At(Slopes.bend[k][p], x);
    }
  }
}

void LocalCurves::Reach(const std::array<double, 3>& away)
{
  for (std::size_t p = 0; p < 6; ++p)
  {
    curves[p] = Beside(Slopes.curve[p], away);
    for (std::size_t k = 0; k < 3; ++k)
    {
      bends[k][p] = Beside(Slopes.bend[k][p], away);
    }
  }
}

LocalExpansion::LocalExpansion(
  const EdgeNode& node, const EdgeFunctions::View& view, double slopeError)
  : Curves(node, view.xi)
{
  Mat3 turned(0.0); // M J
  double errors[3] = {};
  for (int k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    for (int j = 0; j < 3; ++j)
    {
      const Vec3& column = view.jacobian[j];
      turned[j][k] = row[0] * column.x + row[1] * column.y + row[2] * column.z;
      for (int c = 0; c < 3; ++c)
      {
        errors[k] += std::fabs(row[c]) * (slopeError + edges::kRoundoffs * std::fabs(column[c]));
      }
    }
  }
  const Mat3 inverse = glm::inverse(turned);
  const Mat3 product = inverse * turned;
  for (int k = 0; k < 3; ++k)
  {
    double size = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      Inverse[k][j] = inverse[j][k];
      Turn[k] +=
        std::fabs(product[j][k] - (j == k ? 1.0 : 0.0)) + std::fabs(inverse[j][k]) * errors[j];
      size += std::fabs(inverse[j][k]) * edges::SumOf({ turned[0][j], turned[1][j], turned[2][j] });
    }
    Turn[k] += edges::kRoundoffs * size;
    // The comparison is written so that a NaN is not known.
    Known = Known && Turn[k] <= kMaxOff;
    for (std::size_t p = 0; p < 6; ++p)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        Bend[k][p] += Inverse[k][j] * Curves.bend[j][p];
      }
    }
  }
}

void LocalExpansion::Off(const double (&away)[3], double (&off)[3])
{
  Curves.Reach({ away[0], away[1], away[2] });
  double beside[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    beside[k] = edges::Quadratic(Curves.bends[k], away);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    double form[6];
    std::ranges::transform(Bend[k], form, [](double b) { return std::fabs(b); });
    off[k] = edges::Quadratic(form, away);
    for (std::size_t j = 0; j < 3; ++j)
    {
      // Includes the rounding of Bend's sums.
      off[k] += std::fabs(Inverse[k][j]) *
        (beside[j] + edges::kRoundoffs * MagnitudeOf(Curves.bend[j], away));
    }
    off[k] *= 0.5;
  }
  edges::Solve(Turn, off);
}

double LocalExpansion::Curved(const double (&away)[3], const Vec3& slope, double error)
{
  double off[3];
  Off(away, off);
  double along[3] = {}; // F' Inverse
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double own = slope[static_cast<int>(k)];
    const double turned = Turn[k] / (1.0 - std::max({ Turn[0], Turn[1], Turn[2] }));
    sum += std::fabs(own) * turned * std::max({ off[0], off[1], off[2] }) + error * off[k];
    for (std::size_t j = 0; j < 3; ++j)
    {
      along[j] += own * Inverse[k][j];
    }
  }
  double form[6];
  for (std::size_t p = 0; p < 6; ++p)
  {
    double own = Curves.curve[p];
    double size = std::fabs(own);
    double beside = Curves.curves[p];
    for (std::size_t j = 0; j < 3; ++j)
    {
      const double bent = along[j] * Curves.bend[j][p];
      own -= bent;
      size += std::fabs(bent);
      beside += std::fabs(along[j]) * Curves.bends[j][p];
    }
    form[p] = std::fabs(own) + beside + 4.0 * edges::kRoundoffs * size;
  }
  return (sum + 0.5 * edges::Quadratic(form, away)) * edges::kUp;
}
} // namespace pixelexact
