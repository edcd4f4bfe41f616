// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Mat.h"
#include "Core/Questions/EdgeNode.h"
#include "Core/Questions/Outline.h"
#include "Core/Questions/ValueSet.h"

#include <array>
#include <optional>

namespace pixelexact
{
/// A straight edge or a flat convex polygon, widened by `slack` in each coordinate, in world units.
struct WideOutline
{
  Outline outline;
  double slack = 0.0;
};

/// The box that holds the region.
[[nodiscard]] Box3 BoxOf(const WideOutline& region);

/// An element's affine map with its certified deviation; see ElementBounds.
class EdgeFrame
{
public:
  EdgeFrame(Shape shape, const ElementBounds& bounds);

  /// Whether a region is proven to miss the element.
  [[nodiscard]] bool Misses(const EdgeFunctions& functions, const WideOutline& region) const;

private:
  bool Known;
  Vec3 Start; ///< in xi, the middle of the shape
  Vec3 Origin;
  Mat3 Inverse;
  /// The element's ends, moved outwards by the deviation.
  std::array<EdgeNodeEnd, 6> Ends;
};

/// The result of Meet for a region and a node.
struct EdgeMeeting
{
  std::optional<Interval> values; ///< hold those of the node in the region; nothing: there are none
  // Reasons why smaller nodes would give narrower bounds:
  bool bends = false;  ///< the map bends, or the field is no polynomial
  bool curves = false; ///< the field bends, over a node that is larger than the region
};

/// Whether a region is proven to miss a node's image: by its box and, where the node is regular, by
/// the affine map.
[[nodiscard]] bool Misses(
  const EdgeFunctions& functions, const EdgeNode& node, const WideOutline& region);

/// The point about which an expression was expanded in a node, for the next nodes that hold it: it
/// is near the region, and values of expressions cost much.
struct KeptExpansion
{
  std::optional<EdgeFunctions::View> view;
  std::optional<EdgeFunctions::ValueAndSlope> jet;
};

/// Bounds the values in a regular node, from the second-order expansion about a point of it near
/// the region. Refines only while the values meet `wanted`. `face`: an end of the node that is a
/// face of the element, to bound the values on it alone; null: the whole node. `kept`: of this
/// region and function; null: nothing is kept.
[[nodiscard]] EdgeMeeting Meet(const EdgeFunctions& functions, const EdgeNode& node,
  const WideOutline& region, const ValueSet& wanted, const EdgeNodeEnd* face = nullptr,
  KeptExpansion* kept = nullptr);
} // namespace pixelexact
