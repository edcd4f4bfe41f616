// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/LaneBuffer.h"
#include "Core/Element/Mesh.h"
#include "Core/Math/Mat.h"
#include "Trace/TraceTile.h"

#include <glm/vec2.hpp>

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Phi(xi), and its Jacobian where wanted, of some points of an element, in the element's units.
class MappedPoints
{
public:
  MappedPoints(const Mesh& mesh, int element, std::span<const Vec3> xi, bool withJacobians)
    : Stride(static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size()))))
    , Storage((withJacobians ? 12 : 3) * Stride)
  {
    double* arrays[12];
    for (std::size_t k = 0; k < Storage.size() / Stride; ++k)
    {
      arrays[k] = &Storage[k * Stride];
    }
    const Space& space = mesh.map.SpaceOf(element);
    const KernelSet kernels = KernelsFor(space);
    const LaneBuffer lanes(xi);
    const double* const coefficients = mesh.map.Coefficients(element);
    if (withJacobians)
    {
      kernels.gradient(space, coefficients, 3, lanes.View(), arrays, arrays + 3);
    }
    else
    {
      kernels.value(space, coefficients, 3, lanes.View(), arrays);
    }
  }
  [[nodiscard]] Vec3 At(std::size_t i) const
  {
    return { Storage[i], Storage[Stride + i], Storage[2 * Stride + i] };
  }
  /// Of the Jacobian, entry by entry, row by row.
  [[nodiscard]] std::array<const double*, 9> Jacobians() const
  {
    std::array<const double*, 9> columns;
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
      columns[k] = &Storage[(3 + k) * Stride];
    }
    return columns;
  }
  [[nodiscard]] Mat3 Jacobian(std::size_t i) const
  {
    Mat3 jacobian;
    for (int c = 0; c < 3; ++c)
    {
      for (int d = 0; d < 3; ++d)
      {
        jacobian[d][c] = Storage[static_cast<std::size_t>(3 + 3 * c + d) * Stride + i];
      }
    }
    return jacobian;
  }

private:
  std::size_t Stride;
  std::vector<double> Storage;
};

class TileVisit;

/// Near a pixel, the line on the image along which the surface that it shows crosses a face of the
/// pixel's own element.
struct FaceLine
{
  std::size_t pixel = 0; ///< of the frame
  int element = -1;
  int face = 0;             ///< in the order of FacesOf
  double distance = 0.0;    ///< of the pixel's centre, in pixels; below 0: just beyond the face
  glm::dvec2 towards{};     ///< the unit vector from the pixel to the line, on the image
  double elementSize = 0.0; ///< of the element across the face, on the image, in pixels
  int lyingOn = -1;         ///< the face on which the surface lies there; -1: on none
};

/// A line that may be within reach of a pixel, and the way to it on the image. Distances of xi are
/// those from the face's plane (FacePlane).
struct FaceSearch
{
  /// A search is worth while where the line is expected within so many times the reach.
  static constexpr double kSlack = 1.5;
  /// Pixels by which a line's place moves in the last step, at most.
  static constexpr double kSettled = 0.02;

  FaceLine line;
  int layer = 0;
  ImagePosition from{};
  Vec3 position{ 0.0 };
  Vec3 step{ 0.0 };       ///< on the tangent plane, a pixel towards the line
  Vec3 xi{ 0.0 };         ///< at the pixel
  Vec3 mapped{ 0.0 };     ///< Phi(xi), in the element's units
  Mat3 inverse{};         ///< of the Jacobian there, in the element's units
  double atPixel = 0.0;   ///< distance of xi
  double slope = 0.0;     ///< its fall, a pixel, to first order
  double root = 0.0;      ///< pixels to where the line is expected
  double tried = 0.0;     ///< pixels to where the surface is asked for next
  double reached = 0.0;   ///< the last place where it was found
  double atReached = 0.0; ///< distance of xi there
  bool open = true;
  bool found = false;

  /// Where the surface is asked for next.
  [[nodiscard]] ImagePosition Place() const
  {
    return { from[0] + tried * line.towards.x, from[1] + tried * line.towards.y };
  }
  /// With the distance of xi where the surface was asked for.
  void Advance(double distance, double reach);
};

/// Takes all searches to their end: on the surface itself, so that it does not matter how surface
/// and element bend on the way. Sets `found` and the lines' distances.
void Follow(std::span<FaceSearch> searches, const TileVisit& tile, double reach);
} // namespace pixelexact
