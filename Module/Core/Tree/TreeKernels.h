// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Tree/NodeFrame.h"

#include <cstdint>

// A tree's nodes against many points at once; dispatched at run time to the instruction set. What
// is said of a point depends on that point and the node alone.
namespace pixelexact
{
/// Points are asked for in groups of at most this many, a bit each.
inline constexpr int kGroupPoints = 64;

/// A place of each point of a group, coordinate by coordinate.
struct GroupLanes
{
  alignas(64) double x[3][kGroupPoints];
};

/// A root of each point of a group: a xi, and how far beyond a box's reach it may lie to count as
/// reached; NaN where there is none, or nobody knows where it really is.
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

/// What a node says of points, a bit each; or of boxes of points.
struct NodeClassification
{
  /// A xi of the node's box might map to the point; to all others hull or planes prove that none
  /// does.
  std::uint64_t near = 0;
  /// Of those near: a xi of the node's box does map to the point, by proof.
  std::uint64_t held = 0;
  /// Of boxes near: the node says the same of all points in it, near and not held.
  std::uint64_t whole = 0;
};

struct TreeKernels
{
  /// Of the points in `bits`, y in the element's units, padded to whole packs.
  NodeClassification (*classify)(
    const NodeFrame& frame, const double* const y[3], std::uint64_t bits);
  /// The same with ImagePlane::wider for points that are excluded.
  NodeClassification (*classifyWidely)(
    const NodeFrame& frame, const double* const y[3], std::uint64_t bits);
  /// That of whole boxes: not near where judgeWidely would exclude all points, held where it would
  /// call all held.
  NodeClassification (*classifyBoxesWidely)(
    const NodeFrame& frame, const BoxesOfGroups& boxes, std::uint64_t bits);
  /// Of the points in `bits`, those whose root lies in the box, reaching beyond its ends by `reach`
  /// of its widths (see IsRegular), or beyond that by no more than its tolerance.
  std::uint64_t (*reached)(
    const EtaBox& box, Shape shape, double reach, const GroupRoots& roots, std::uint64_t bits);
  /// y of `count` points from `begin` on, whole packs: (x - centre) inverseSize.
  void (*scale)(const LanePoints& x, int begin, int count, const double* centre, double inverseSize,
    double* const y[3]);
};

const TreeKernels& GetTreeKernels();
} // namespace pixelexact
