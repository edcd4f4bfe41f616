// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Modules/FaceSearch.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// The pixels that show one element, as a structure of arrays.
class FacePixels
{
public:
  /// Clears the object and reserves capacity for `most` pixels.
  void Begin(std::size_t most);
  void Add(double u, double v, const Vec3& xi, const Vec3& position, const Vec3& normal);

  /// u, v and three coordinates each of xi, position and normal.
  static constexpr std::size_t kColumns = 11;
  [[nodiscard]] const double* Column(std::size_t k) const { return Storage.data() + k * Stride; }
  [[nodiscard]] std::size_t Count() const { return Size; }

private:
  std::size_t Size = 0;
  std::size_t Stride = 0;
  std::vector<double> Storage;
};

class TileVisit;

/// Finds the lines of a tile's pixels. Keeps its arrays from tile to tile.
///
/// To first order, the distance of a face is its distance in xi over the gradient of that distance
/// on the image. The gradient follows from the Jacobian, the surface's tangent plane and the spread
/// of rays. Lines that may be within reach are then searched on the surface itself. The ray through
/// the expected place meets the surface, and the element's map is inverted there, until the place
/// settles. So the curvature of surface and element causes no error. Where the surface ends before
/// the line, there is no line.
class FaceLines
{
public:
  /// Largest sine of the angle between surface and face at which the surface lies on the face. No
  /// line is drawn there.
  static constexpr double kLyingOn = 1e-6;

  /// Lines nearer than `reach` pixels, pixel by pixel; valid until the next call. Reads Verdict,
  /// Element, Xi, Position, Normal and Layer of the nearest sheet. Throws Error if nothing can be
  /// traced.
  [[nodiscard]] std::span<const FaceLine> Find(TileVisit& tile, double reach);

private:
  /// Neighbouring pixels of a row that show the same element and layer.
  struct Run
  {
    int element = -1;
    int layer = 0;
    std::size_t pixel = 0; ///< the first
    int x = 0;
    int y = 0;
    int count = 0;
  };

  void GatherRuns(TileVisit& tile);
  void Begin(TileVisit& tile, std::span<const Run> runs, double reach);

  std::vector<Run> Runs;
  std::vector<Vec3> Xi; ///< of an element's pixels
  FacePixels Pixels;
  std::vector<std::uint8_t> Near;
  std::vector<FaceSearch> Searches;
  std::vector<FaceLine> Found;
};
} // namespace pixelexact
