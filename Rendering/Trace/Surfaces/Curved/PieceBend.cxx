// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceBend.h"

#include "Core/Bernstein/Krawczyk.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
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
