// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Tree/NodeFrame.h"

#include <cstdint>

// Tests a tree's nodes against many points at once; dispatched at run time to the instruction set.
// The result for a point depends on that point and the node alone.
namespace pixelexact
{
/// Points are tested in groups of at most this many, a bit each.
inline constexpr int kGroupPoints = 64;

/// One place for each point of a group, coordinate by coordinate.
struct GroupLanes
{
  alignas(64) double x[3][kGroupPoints];
};

/// One root for each point of a group: a xi, and the distance beyond a box's reach at which it
/// still counts as reached; NaN where there is no root, or its exact place is unknown.
struct GroupRoots
{
  GroupLanes xi;
  alignas(64) double tolerance[kGroupPoints];
};

/// Boxes of y about up to 64 groups of points: middles and half widths, coordinate by coordinate.
struct BoxesOfGroups
{
  GroupLanes middle;
  GroupLanes reach;
};

/// The classification of points by a node, a bit each; or of boxes of points.
struct NodeClassification
{
  /// Points to which a xi of the node's box might map; for all others hull or planes prove that
  /// none does.
  std::uint64_t near = 0;
  /// The points in `near` to which a xi of the node's box is proven to map.
  std::uint64_t held = 0;
  /// The boxes in `near` whose points are all classified alike, near and not held.
  std::uint64_t whole = 0;
};

struct TreeKernels
{
  /// Classifies the points in `bits`; y is in the element's units, padded to whole packs.
  NodeClassification (*classify)(
    const NodeFrame& frame, const double* const y[3], std::uint64_t bits);
  /// The same with ImagePlane::wider for points that are excluded.
  NodeClassification (*classifyWidely)(
    const NodeFrame& frame, const double* const y[3], std::uint64_t bits);
  /// Classifies whole boxes: not near where classifyWidely would exclude all points, held where it
  /// would hold all.
  NodeClassification (*classifyBoxesWidely)(
    const NodeFrame& frame, const BoxesOfGroups& boxes, std::uint64_t bits);
  /// Returns the points in `bits` whose root lies in the box, extended beyond its ends by `reach`
  /// of its widths (see IsRegular), or farther by at most its tolerance.
  std::uint64_t (*reached)(
    const EtaBox& box, Shape shape, double reach, const GroupRoots& roots, std::uint64_t bits);
  /// Computes y of `count` points from `begin` on, in whole packs: (x - centre) inverseSize.
  void (*scale)(const LanePoints& x, int begin, int count, const double* centre, double inverseSize,
    double* const y[3]);
};

const TreeKernels& GetTreeKernels();
} // namespace pixelexact
