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

/// Where a contour is nearest to a point of the image.
struct ContourFoot
{
  double distance = 0.0; ///< in pixels, along `towards`
  glm::dvec2 towards{};  ///< across the contour, unit length
};

/// The field between the corners of pixels. A pixel is *whole* where all its corners are exact,
/// show finite values of one layer, and one sheet of it; there the field is taken for bilinear,
/// which is off by an eighth of its second derivatives at most: a contour by as much over the
/// gradient. In pixels that are not whole nothing is said. Keeps its arrays from tile to tile.
class ContourCells
{
public:
  /// Two corners, side by side, are of different sheets, because the surface hides a part of
  /// itself, where the sine of the angle between chord and surface is more. On one sheet that is
  /// half of the angle by which it turns from corner to corner.
  static constexpr double kOffTangent = 0.5;
  /// And where the chord is longer by this factor than it would be on the tangent plane, of the two
  /// ends the one that faces the eye more. On one sheet that is 2 at a silhouette.
  static constexpr double kTooLong = 3.0;

  /// `pixels`: whose corners may be read; they must outlive what is asked. `camera`: to tell sheets
  /// apart, by the corners' positions and normals; null: there is one.
  void Begin(const LatticePart& corners, const TileArea& pixels, const Camera* camera);

  /// The layer of a whole pixel, else kNoLayer.
  [[nodiscard]] std::uint8_t LayerOf(int x, int y) const { return Layers[At(x, y)]; }

  /// For each of `area`'s pixels, row by row, the least and the greatest value in whole pixels that
  /// are no farther than `far`, each way; where there are none, the first is above the second.
  [[nodiscard]] const std::vector<std::array<double, 2>>& RangesAbout(
    const TileArea& area, int far);

  /// The contour that is met by going up or down the field, from a place in a whole pixel, such as
  /// its middle, and through whole pixels of its layer no farther than `far`, each way. None where
  /// that does not end at the value.
  [[nodiscard]] std::optional<ContourFoot> Find(
    const glm::dvec2& from, double value, int far) const;

  /// The field at a place; none where the pixel is not whole.
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
