// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceCurvature.h"

#include "Core/Math/Interval.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
using Corners = std::array<double, 8>;

/// Half of the mean change from the lower to the upper ends along a direction.
template <class Value>
Value ChangeAlong(unsigned direction, const std::array<Value, 8>& at)
{
  Value sum{};
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Value part = 0.125 * at[corner];
    sum += (corner >> direction & 1U) != 0 ? part : -part;
  }
  return sum;
}

/// The range of a polynomial minus the function that is linear in each direction and has these
/// values at the corners. The coefficients of the latter are its values on the grid of the
/// polynomial's coefficients.
Interval LessThese(const Corners& at, const BoxPolynomial& p)
{
  std::array<std::size_t, 3> last;
  std::array<double, 3> step;
  std::array<std::size_t, 3> stride;
  std::size_t count = 1;
  for (std::size_t d = 3; d-- > 0;)
  {
    const auto n = static_cast<std::size_t>(p.degree[d]);
    // A direction without variation is compared at both ends.
    last[d] = std::max<std::size_t>(n, 1);
    step[d] = 1.0 / static_cast<double>(last[d]);
    stride[d] = n > 0 ? count : 0;
    count *= n + 1;
  }
  const auto between = [](double a, double b, double t) { return a + t * (b - a); };
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  for (std::size_t i = 0; i <= last[0]; ++i)
  {
    const double s = static_cast<double>(i) * step[0];
    for (std::size_t j = 0; j <= last[1]; ++j)
    {
      const double t = static_cast<double>(j) * step[1];
      const auto row = [&](std::size_t k)
      { return between(between(at[k], at[k + 1], s), between(at[k + 2], at[k + 3], s), t); };
      const double from = row(0);
      const double change = (row(4) - from) * step[2];
      const double* const b = &p.b[i * stride[0] + j * stride[1]];
      for (std::size_t k = 0; k <= last[2]; ++k)
      {
        const double off = b[k * stride[2]] - (from + static_cast<double>(k) * change);
        lower = std::min(lower, off);
        upper = std::max(upper, off);
      }
    }
  }
  return { lower, upper };
}
} // namespace

float AboveFloat(double value)
{
  const auto near = static_cast<float>(value);
  return near < value ? std::nextafter(near, std::numeric_limits<float>::infinity()) : near;
}

PieceCorners::PieceCorners(Shape shape, const CurvedPiece& piece)
{
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      eta[d] =
        (corner >> static_cast<unsigned>(d) & 1U) != 0 ? piece.box.upper[d] : piece.box.lower[d];
    }
    Off[corner] = TensorToReference(shape, eta) - piece.centre;
  }
  Mat3 way;
  for (unsigned d = 0; d < 3; ++d)
  {
    way[static_cast<int>(d)] = ChangeAlong(d, Off);
  }
  ToXi = glm::inverse(way);
}

bool PieceCorners::SetCurvature(
  std::span<const BoxPolynomial> by, std::size_t c, CurvedPiece& piece) const
{
  Mat3 second;
  for (std::size_t d = 0; d < 3; ++d)
  {
    Corners at;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      at[corner] = by[d].AtCorner(corner).Middle();
    }
    const Vec3 change(ChangeAlong(0, at), ChangeAlong(1, at), ChangeAlong(2, at));
    second[static_cast<int>(d)] = change * ToXi;
  }
  // The stored matrix is symmetric; `rest` bounds the difference.
  float* const kept = piece.curve[c];
  for (int d = 0; d < 3; ++d)
  {
    const int e = (d + 1) % 3;
    kept[d] = static_cast<float>(second[d][d]);
    kept[d + 3] = static_cast<float>(0.5 * (second[d][e] + second[e][d]));
    second[d][d] = kept[d];
    second[d][e] = second[e][d] = kept[d + 3];
  }
  bool isFinite = true;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const Vec3& row = second[static_cast<int>(d)];
    Corners at;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      at[corner] = piece.slope[c][d] + glm::dot(row, Off[corner]);
    }
    const double size =
      std::fabs(piece.slope[c][d]) + piece.radius[c][d] + 2.0 * glm::dot(glm::abs(row), piece.half);
    // Third derivatives often shift slopes to one side; a bound about the middle is half as large.
    const Interval less = LessThese(at, by[d]);
    const auto shift = static_cast<float>(less.Middle());
    const double rest = less.RadiusAround(shift) + by[d].error + Gamma(32) * size;
    isFinite = isFinite && std::isfinite(size) && rest < std::numeric_limits<float>::max();
    piece.shift[c][d] = shift;
    piece.rest[c][d] = AboveFloat(rest);
  }
  return isFinite;
}
} // namespace pixelexact
