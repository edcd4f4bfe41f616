// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeNode.h"
#include "Core/Questions/ValueSet.h"

#include <cstdint>

namespace pixelexact
{
/// A straight edge, widened by `slack` in each coordinate, in world units.
struct WideEdge
{
  Vec3 from{ 0.0 };
  Vec3 to{ 0.0 };
  double slack = 0.0;
};

/// Of an edge and the points of a node that have one of some values.
enum class EdgeMeeting : std::uint8_t
{
  None,   ///< proven: it holds none of them
  Near,   ///< it may
  Coarse, ///< and smaller nodes would tell more
};

/// Whether an edge is proven to miss a node's image: by its box and, where the node is regular, by
/// the affine map.
[[nodiscard]] bool Misses(
  const EdgeFunctions& functions, const EdgeNode& node, const WideEdge& edge);

/// In a regular node, from the second-order expansion about a point of it near the edge.
[[nodiscard]] EdgeMeeting Meet(const EdgeFunctions& functions, const EdgeNode& node,
  const ValueSet& wanted, const WideEdge& edge);
} // namespace pixelexact
