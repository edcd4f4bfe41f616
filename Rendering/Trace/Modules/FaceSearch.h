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
/// Phi(xi), and its Jacobian if requested, at points of one element, in the element's units.
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
  /// The entries of the Jacobians, row-major; each array has one entry per point.
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

/// A line near a pixel, on which the pixel's surface crosses a face of the pixel's element.
struct FaceLine
{
  std::size_t pixel = 0; ///< of the frame
  int element = -1;
  int face = 0;             ///< number in FacesOf
  double distance = 0.0;    ///< of the pixel's centre, in pixels; below 0: beyond the face
  glm::dvec2 towards{};     ///< the unit vector from the pixel to the line, on the image
  double elementSize = 0.0; ///< of the element across the face, on the image, in pixels
  int lyingOn = -1;         ///< the face on which the surface lies there; -1: on none
};

/// The search of a line near a pixel, along a direction on the image. Distances of xi are from the
/// face's plane (FacePlane).
struct FaceSearch
{
  /// Lines are searched if their expected distance is at most kSlack times the reach.
  static constexpr double kSlack = 1.5;
  /// Largest change of a line's distance in the last step, in pixels.
  static constexpr double kSettled = 0.02;

  FaceLine line;
  int layer = 0;
  ImagePosition from{};
  Vec3 position{ 0.0 };
  Vec3 step{ 0.0 };       ///< on the tangent plane, per pixel towards the line
  Vec3 xi{ 0.0 };         ///< at the pixel
  Vec3 mapped{ 0.0 };     ///< Phi(xi), in the element's units
  Mat3 inverse{};         ///< of the Jacobian there, in the element's units
  double atPixel = 0.0;   ///< distance of xi
  double slope = 0.0;     ///< decrease of that distance per pixel, to first order
  double root = 0.0;      ///< expected distance of the line, in pixels
  double tried = 0.0;     ///< distance of the next evaluation, in pixels
  double reached = 0.0;   ///< distance of the last hit on the surface, in pixels
  double atReached = 0.0; ///< distance of xi there
  bool open = true;
  bool found = false;

  /// Image position of the next evaluation.
  [[nodiscard]] ImagePosition Place() const
  {
    return { from[0] + tried * line.towards.x, from[1] + tried * line.towards.y };
  }
  /// Takes the distance of xi at Place() and sets the next place, or ends the search.
  void Advance(double distance, double reach);
};

/// Completes all searches. Points are evaluated on the surface itself, so the curvature of surface
/// and element causes no error. Sets `found` and the lines' distances.
void Follow(std::span<FaceSearch> searches, const TileVisit& tile, double reach);
} // namespace pixelexact
