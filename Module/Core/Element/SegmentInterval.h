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
  /// The largest distance in each coordinate of a segment's points from the segment, world units;
  /// null: zero.
  const double* slack = nullptr;
};

/// In place of a component: the Euclidean norm of all components. For a field of one component this
/// is the component itself, with its sign.
inline constexpr int kNormOfAll = -1;

/// Computes one interval for each segment of `element` that holds the world values of a component
/// of `field` on it, as in section 5.3 of the paper: the steps of the evaluation in interval
/// arithmetic, without derivatives. The intervals are wider for higher orders, and shrink about
/// linearly with the segments' length.
///
/// Proven: through the stored map Phi, moved by whatever is within uncertainty[element] in each
/// coordinate, a box in xi holds exactly one preimage of each point of the segment; these lie in
/// the shape, or beyond its faces by no more than twice the distance that the uncertainty of the
/// map and the slack explain through its inverse; the stored field's exact values there lie in the
/// interval.
///
/// The interval is -inf to inf where nothing is proven: the segment may leave the element between
/// its ends; it is too long for one box; the Jacobian is singular, or nearly, in the box; the apex
/// of a pyramid is near; a coefficient, point or xi is not finite; EnclosureProblem does not
/// support the element's size.
///
/// Method: Krawczyk's operator (Enclosure.h) on a box around both ends' xi, with epsilon-inflation,
/// and the evaluation over the proven box in balls. Assumes rounding to nearest. A segment's
/// interval depends on that segment and the element alone.
void SegmentIntervals(const Mesh& mesh, const Field& field, int component, int element,
  const ElementSegments& segments, std::span<Interval> intervals);

/// The lanes' results for a field's values, in the element's units; see SegmentIntervalKernels.cxx.
/// Arrays of PaddedCount.
struct SegmentsInLanes
{
  double* const* middle; ///< of each component
  double* const* radius; ///< infinite where nothing is proven
  /// Two bounds in each coordinate: the distance of the preimages from the line between the ends'
  /// xi, and the effect of the uncertainty of the map and the slack on all of them.
  double* stray[3];
  double* tolerance;
};
void EncloseSegmentsInLanes(
  const EnclosureTask& task, const ElementSegments& segments, const SegmentsInLanes& out);
} // namespace pixelexact
