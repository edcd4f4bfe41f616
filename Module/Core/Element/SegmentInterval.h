// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/EnclosureTask.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"
#include "Core/Math/Interval.h"

#include <span>

namespace pixelexact
{
/// Straight segments between points whose preimages lie in one element; arrays as for the kernels,
/// of PaddedCount(from.count).
struct ElementSegments
{
  LanePoints xiFrom; ///< approximate preimages (a Locator's)
  LanePoints xiTo;
  LanePoints from; ///< in the world
  LanePoints to;
  /// Of each, world units: how far off the segment its points may lie, in each coordinate; null:
  /// not at all.
  const double* slack = nullptr;
};

/// In place of a component: the Euclidean norm of all, which of a single one is itself, sign and
/// all.
inline constexpr int kNormOfAll = -1;

/// Intervals that hold the world values of a component of `field` on segments of `element`, one for
/// each, as the paper has them (section 5.3): the steps of the evaluation in interval arithmetic,
/// without derivatives. So they are wide, the wider the higher the order, and shrink about linearly
/// with the segments' length.
///
/// What is proven: through the stored map Phi, moved by whatever is within uncertainty[element] in
/// each coordinate, a box in xi holds exactly one preimage of each point of the segment; these lie
/// in the shape, or beyond its faces by no more than twice what the uncertainty of the map and the
/// slack explain, seen through its inverse; the stored field's exact values there lie in the
/// interval.
///
/// Everything, -inf to inf, where nothing is proven: the segment may leave the element between its
/// ends; it is too long for one box; the Jacobian is singular, or nearly, in the box; the apex of a
/// pyramid is near; a coefficient, point or xi is not finite; the element's size is none that
/// EnclosureProblem takes.
///
/// Method: Krawczyk's operator (Enclosure.h) on a box around both ends' xi, with epsilon-inflation;
/// the evaluation over the box that it proves, in balls. Assumes rounding to nearest. A segment's
/// interval depends on that segment and the element alone.
void SegmentIntervals(const Mesh& mesh, const Field& field, int component, int element,
  const ElementSegments& segments, std::span<Interval> intervals);

/// What the lanes find of a field's values, in the element's units; see SegmentIntervalKernels.cxx.
/// Arrays of PaddedCount.
struct SegmentsInLanes
{
  double* const* middle; ///< of each component
  double* const* radius; ///< infinite where nothing is proven
  /// In each coordinate, how far the preimages may be from the line between the ends' xi; and what
  /// the uncertainty of the map and the slack make in all of them.
  double* stray[3];
  double* tolerance;
};
void EncloseSegmentsInLanes(
  const EnclosureTask& task, const ElementSegments& segments, const SegmentsInLanes& out);
} // namespace pixelexact
