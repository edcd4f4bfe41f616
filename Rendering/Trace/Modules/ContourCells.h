// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/TraceTile.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pixelexact
{
struct LatticePart;

/// The point of a contour that is nearest to a point of the image.
struct ContourFoot
{
  double distance = 0.0; ///< in pixels, along `towards`
  glm::dvec2 towards{};  ///< across the contour, unit length
};

/// The field between the corners of pixels. A pixel is *whole* if all its corners are exact and
/// show finite values on one sheet of one layer. In whole pixels the field is taken as bilinear.
/// Its error is at most an eighth of the field's second derivatives (per pixel squared); that of a
/// contour is this error over the gradient. Other pixels have no field. Keeps its arrays from tile
/// to tile.
class ContourCells
{
public:
  /// Two neighbouring corners lie on different sheets if the sine of the angle between their chord
  /// and the surface is greater. On one sheet, this angle is half of the surface's turn between the
  /// corners.
  static constexpr double kOffTangent = 0.5;
  /// They also do if the chord is longer by this factor than its image on the tangent plane at the
  /// end that faces the eye more. On one sheet, the factor is 2 at a silhouette.
  static constexpr double kTooLong = 3.0;

  /// `pixels`: those whose corners may be read. `camera`: separates sheets by the corners'
  /// positions and normals; null: there is one sheet. Arguments must outlive all calls for this
  /// tile.
  void Begin(const LatticePart& corners, const TileArea& pixels, const Camera* camera);

  /// The layer of a whole pixel, else kNoLayer.
  [[nodiscard]] std::uint8_t LayerOf(int x, int y) const { return Layers[At(x, y)]; }

  /// For each of `area`'s pixels, row by row: the least and greatest value in whole pixels within
  /// `far` pixels in each direction. The first exceeds the second if there are none.
  [[nodiscard]] const std::vector<std::array<double, 2>>& RangesAbout(
    const TileArea& area, int far);

  /// Follows the field up or down to `value`, from a point in a whole pixel and through whole
  /// pixels of its layer within `far` pixels in each direction. Returns none if the value is not
  /// reached.
  [[nodiscard]] std::optional<ContourFoot> Find(
    const glm::dvec2& from, double value, int far) const;

  /// The field at a point; none if the pixel is not whole.
  [[nodiscard]] std::optional<double> ValueAt(const glm::dvec2& at) const;

private:
  struct Local
  {
    double value = 0.0;
    glm::dvec2 gradient{};
  };

  [[nodiscard]] std::size_t At(int x, int y) const
  {
    return static_cast<std::size_t>(y - Pixels.y0) * static_cast<std::size_t>(Pixels.Width()) +
      static_cast<std::size_t>(x - Pixels.x0);
  }
  [[nodiscard]] bool Holds(int x, int y) const
  {
    return x >= Pixels.x0 && x < Pixels.x1 && y >= Pixels.y0 && y < Pixels.y1;
  }
  [[nodiscard]] Local Evaluate(int x, int y, const glm::dvec2& at) const;

  TileArea Pixels{};
  std::vector<std::uint8_t> Layers;
  std::vector<std::array<double, 4>> Values; ///< at corners: lower left, right, upper left, right
  std::vector<std::array<double, 2>> InRows;
  std::vector<std::array<double, 2>> Ranges;
};
} // namespace pixelexact
