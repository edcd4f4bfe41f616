// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Tree/ElementTree.h"
#include "Core/Tree/TreeKernels.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pixelexact
{
/// A xi to which Newton's iteration converged.
struct InverseRoot
{
  Vec3 xi{ 0.0 };
  /// The last correction, max norm in xi; next to a pyramid's apex, the distance by which xi was
  /// moved into it.
  double residual = 0.0;
  bool inside = false; ///< in the shape or within the faces' tolerance of it
  bool onFace = false; ///< within the faces' tolerance of a face
};

/// The preimages of a point in an element.
struct Preimages
{
  /// Inside: `roots` holds one inside. Outside: proven to hold none. Unknown: neither.
  Verdict verdict = Verdict::Unknown;
  /// The roots in the shape: all of them with Wanted::All where `complete` is set.
  std::vector<InverseRoot> roots;
  bool complete = false;
  int boxes = 0; ///< looked at, for all points asked for together
};

/// Work budget of a point, in about nanoseconds of one core.
inline constexpr std::int64_t kMaxWork = 4'500'000;
/// The largest budget where subdivision of one box of high order costs a large share of kMaxWork.
inline constexpr std::int64_t kMaxWorkOfHighOrders = 9'000'000;
/// A point to locate.
struct SoughtPoint
{
  Vec3 x{ 0.0 };
  /// The root outside the shape to which Newton's iteration converged; NaN where it did not
  /// converge.
  Vec3 known{ std::numeric_limits<double>::quiet_NaN() };
  std::int64_t mostWork = kMaxWork;
};

enum class Wanted : std::uint8_t
{
  First, ///< one preimage is enough
  All
};

/// The certified inverse of an element's map. Searches the element's tree for the preimages of
/// points; fastest for at most kGroupPoints neighbouring points per call.
///
/// A box is finished where its frame excludes the point, or where the map is regular (injective) on
/// it and the one root that it can hold is known. Newton's iteration finds the roots. See
/// Module/Documentation/element-tree.md.
///
/// The result for a point depends on that point and the element alone, not on the other points or
/// on earlier searches. Work is counted as if the tree had to be built for the point; a point that
/// exceeds its budget (`mostWork`) is unknown.
void FindPreimages(ElementTree& tree, std::span<const SoughtPoint> points, Wanted wanted,
  std::span<Preimages> answers);
} // namespace pixelexact
