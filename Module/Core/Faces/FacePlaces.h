// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/ReferenceFace.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// Gauss-Legendre points of [0, 1], ascending, and their weights, which sum to 1.
struct GaussRule
{
  std::vector<double> points;
  std::vector<double> weights;
};
/// Exact for polynomials of degree 2 count - 1, up to rounding; count >= 1.
GaussRule MakeGaussRule(int count);

/// Places on a face, and the weights of a quadrature over the unit square or triangle; none where
/// they are no quadrature.
struct FacePlaces
{
  std::vector<FacePoint> points;
  std::vector<double> weights;
};

/// The places of a face for all orders up to a highest one, made once. Triangles have the corners
/// 0, 0; 1, 0 and 0, 1; their second parameter is collapsed.
class PlacesByOrder
{
public:
  /// Chebyshev points along a parameter, by degree.
  static constexpr int kPointsPerDegree = 8;

  PlacesByOrder(int highestGauss, int highestOrder);

  /// Gauss points, two more along a parameter than the order, with their weights.
  [[nodiscard]] const FacePlaces& GaussOf(int corners, int order) const
  {
    return Gauss[static_cast<std::size_t>(corners - 3)][static_cast<std::size_t>(order)];
  }
  [[nodiscard]] const std::vector<FacePoint>& ChebyshevOf(int corners, int order) const
  {
    return Chebyshev[static_cast<std::size_t>(corners - 3)][static_cast<std::size_t>(order)];
  }

private:
  std::array<std::vector<FacePlaces>, 2> Gauss;
  std::array<std::vector<std::vector<FacePoint>>, 2> Chebyshev;
};
} // namespace pixelexact
