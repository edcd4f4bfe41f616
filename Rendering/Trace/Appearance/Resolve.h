// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Trace/Frame.h"
#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

// Converts the rules of an appearance to numbers: ranges of colours, values of contours.
namespace pixelexact
{
struct View;

using ValueRange = std::optional<std::array<double, 2>>;

/// The proven ranges of a mesh's fields (FieldRange), each computed once.
class FieldRanges
{
public:
  /// Throws as FieldRange; then nothing is kept.
  ValueRange Of(const Mesh& mesh, const Field& field, int component,
    const std::function<void(double)>& progress = {});

private:
  std::map<std::pair<const Field*, int>, ValueRange> Known;
};

/// A layer's colours and contours in numbers.
struct ResolvedLayer
{
  ValueRange range; ///< of the table; none: the table is not read
  ColorMap map;     ///< of the surface
  /// In ascending order, without duplicates.
  std::vector<double> contours;
  std::vector<Rgba> contourColors; ///< one for each contour, or one for all
};

struct ResolvedAppearance
{
  std::vector<ResolvedLayer> layers;
  /// A number of contours was requested on a surface with one value up to rounding, so some
  /// contours are omitted.
  bool ofOneValue = false;
};

/// The buffers of centres that Resolve reads.
[[nodiscard]] Buffer NeedsOfRules(const View& view);

/// `frame`: for rules that depend on its values; null: such ranges are those of no values, and
/// numbers of contours give no contours. `ofAll`: by layer, the values of RangeRule::Of::All;
/// empty: the frame's values are used. Without finite values the range is the table's
/// RangeOfNothing. Throws Error as FieldRange and ColorTable::Over, and for contours of a layer
/// without a field.
[[nodiscard]] ResolvedAppearance Resolve(const View& view, const Frame* frame, FieldRanges& fields,
  const std::vector<ValueRange>& ofAll = {}, const std::function<void(double)>& progress = {});

/// The range of the finite values above `lowest` at the centres of exact pixels on these layers
/// (empty: all layers), including the sheets behind; none if there are no such values.
[[nodiscard]] ValueRange ValuesSeen(
  const Frame& frame, double lowest, const std::vector<bool>& layers = {});
[[nodiscard]] ValueRange ValuesSeen(const Frame& frame, std::size_t layer);

/// The range of the visible values of the layer's group, as RangeRule::Of::Cut; none if there are
/// none.
[[nodiscard]] ValueRange RangeSeen(const View& view, const Frame& frame, std::size_t layer);
} // namespace pixelexact
