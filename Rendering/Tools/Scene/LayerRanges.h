// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// The values at the ends of colour maps.
namespace pixelexact
{
struct Shot;

/// Which range a colour map spans.
struct RangeChoice
{
  enum class Of
  {
    Cut,   ///< the exact values that the picture shows
    Field, ///< a proven enclosure of all values of the field over the mesh
    All,   ///< the exact values that all pictures of an animation show
    Parts, ///< percentiles of the values that the picture shows, a pixel a value
    Ends   ///< as given
  };
  Of of = Of::Cut;
  std::array<double, 2> ends{}; ///< values, or percentages
  bool symmetric = false;       ///< made as wide to both sides of 0
};

/// "cut", "field" or "all", each behind "symmetric-" or not, "symmetric", two numbers with
/// `separator` between them, or two percentages. Throws UsageError.
RangeChoice ReadRange(const std::string& option, const std::string& text, char separator);

/// The smallest and largest finite value of the exact pixels, what is seen through others included,
/// of those above `lowest` and on these layers (empty: all); none: empty.
std::optional<std::array<double, 2>> ValueRange(
  const Frame& frame, double lowest, const std::vector<bool>& layers = {});

/// The range of a layer's colour map. Of::Cut is that of all layers that show the same component of
/// the same field, but for those that are painted in one colour, with `logarithm` of the positive
/// values; [0, 1], or [1, 10], where there is none. Throws Error where Of::Field has no bound, or
/// with `logarithm` one that is not above 0.
std::array<double, 2> RangeOfLayer(const RangeChoice& choice, const Shot& shot, std::size_t layer,
  const Frame& frame, bool logarithm);

/// Pixels whose value, on any sheet, the map of its layer does not show as what it is.
struct PixelsBeyond
{
  std::int64_t below = 0; ///< the first end
  std::int64_t above = 0; ///< the last one
  /// With a logarithm: of values that have none, which get the colour of NaN and are not `below`.
  std::int64_t noLogarithm = 0;
  std::array<double, 2> noLogarithmRange{}; ///< of these
};

/// `ranges`: by layer; none: it is painted in one colour.
PixelsBeyond CountBeyond(const Frame& frame,
  const std::vector<std::optional<std::array<double, 2>>>& ranges, bool logarithm);
} // namespace pixelexact
