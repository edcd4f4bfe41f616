// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceCurvature.h"

#include "Core/Bernstein/Krawczyk.h"
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

namespace
{

/// The largest row sum of the inverse's magnitudes times those of another matrix; infinite without
/// an inverse.
double Relative(const SmallMatrix& matrix, const SmallMatrix& radius, std::size_t columns)
{
  const auto inverse = Inverse(3, matrix);
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t j = 0; j < columns; ++j)
      {
        sum += inverse ? std::fabs((*inverse)[i][k]) * radius[k][j] : kInfinity;
      }
    }
    largest = std::max(largest, sum);
  }
  return std::isnan(largest) ? kInfinity : largest;
}

Vec3 LengthsOf(const SmallMatrix& m)
{
  Vec3 length;
  for (std::size_t j = 0; j < 3; ++j)
  {
    length[static_cast<int>(j)] = std::hypot(m[0][j], m[1][j], m[2][j]);
  }
  return length;
}
} // namespace

double BendOf(const CurvedPiece& piece, bool hasField)
{
  SmallMatrix slope{};
  SmallMatrix radius{};
  if (hasField)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      std::ranges::copy(piece.slope[c], slope[c].begin());
      std::ranges::copy(piece.radius[c], radius[c].begin());
    }
    const auto inverse = Inverse(3, slope);
    double length = 0.0;
    double change = 0.0;
    for (std::size_t j = 0; inverse && j < 3; ++j)
    {
      double sum = 0.0;
      double around = 0.0;
      for (std::size_t d = 0; d < 3; ++d)
      {
        sum += piece.slope[3][d] * (*inverse)[d][j];
        around += piece.radius[3][d] * std::fabs((*inverse)[d][j]);
      }
      length = std::hypot(length, sum);
      change = std::hypot(change, around);
    }
    return inverse && length > 0.0 ? std::max(Relative(slope, radius, 3), change / length)
                                   : kInfinity;
  }
  // Two tangents in the face and the normal, not normalised.
  const Vec3 across(piece.slope[3][0], piece.slope[3][1], piece.slope[3][2]);
  const Vec3 size = glm::abs(across);
  const int last = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  for (int k = 0; k < 2; ++k)
  {
    const int d = (last + 1 + k) % 3;
    const double back = across[d] / across[last];
    for (std::size_t c = 0; c < 3; ++c)
    {
      slope[c][static_cast<std::size_t>(k)] = piece.slope[c][d] - back * piece.slope[c][last];
      radius[c][static_cast<std::size_t>(k)] =
        piece.radius[c][d] + std::fabs(back) * piece.radius[c][last];
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    const std::size_t p = (c + 1) % 3;
    const std::size_t q = (c + 2) % 3;
    slope[c][2] = slope[p][0] * slope[q][1] - slope[q][0] * slope[p][1];
  }
  const Vec3 length = LengthsOf(slope);
  const double scale = 0.5 * (length.x + length.y) / length.z;
  for (auto& row : slope)
  {
    row[2] *= scale;
  }
  return Relative(slope, radius, 2);
}
} // namespace pixelexact
