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

// From the rules of an appearance to numbers: the ranges of colours, the values of contours.
namespace pixelexact
{
struct View;

using ValueRange = std::optional<std::array<double, 2>>;

/// The proven ranges of fields of a mesh (FieldRange), each found once.
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
  ValueRange range; ///< of the table; none: it is not read
  ColorMap map;     ///< of the surface
  /// In ascending order, each once.
  std::vector<double> contours;
  std::vector<Rgba> contourColors; ///< one for each, or one for all
};

struct ResolvedAppearance
{
  std::vector<ResolvedLayer> layers;
  /// Whether a number of contours was asked for where a surface shows one value, up to rounding, so
  /// that some were left out.
  bool ofOneValue = false;
};

/// The buffers of centres that Resolve reads.
[[nodiscard]] Buffer NeedsOfRules(const View& view);

/// `frame`: where a rule follows from its values; null: such ranges are those of no values, and
/// numbers of contours are left out. `ofAll`: by layer, the values of RangeRule::Of::All; empty:
/// they are the frame's. Where there are no finite values the range is the table's RangeOfNothing.
/// Throws Error as FieldRange and ColorTable::Over, and for contours of a layer without a field.
[[nodiscard]] ResolvedAppearance Resolve(const View& view, const Frame* frame, FieldRanges& fields,
  const std::vector<ValueRange>& ofAll = {}, const std::function<void(double)>& progress = {});

/// The range of the finite values at the centres of exact pixels above `lowest` on these layers
/// (empty: all), sheets behind others included; none: there are none.
[[nodiscard]] ValueRange ValuesSeen(
  const Frame& frame, double lowest, const std::vector<bool>& layers = {});
[[nodiscard]] ValueRange ValuesSeen(const Frame& frame, std::size_t layer);

/// The range that the values of a group of layers give, where there are any: as RangeRule::Of::Cut.
[[nodiscard]] ValueRange RangeSeen(const View& view, const Frame& frame, std::size_t layer);
} // namespace pixelexact
