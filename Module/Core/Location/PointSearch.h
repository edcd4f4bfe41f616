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
/// A xi where Newton's iteration converged.
struct InverseRoot
{
  Vec3 xi{ 0.0 };
  /// The last correction, max norm in xi; next to a pyramid's apex, how far xi was moved into it.
  double residual = 0.0;
  bool inside = false; ///< in the shape or within the faces' tolerance of it
  bool onFace = false; ///< within the faces' tolerance of a face
};

/// What an element holds of a point.
struct Preimages
{
  /// Inside: `roots` holds one inside; Outside: proven to hold none. Unknown: neither.
  Verdict verdict = Verdict::Unknown;
  /// In the shape. All of them, where all were asked for and `complete` is set.
  std::vector<InverseRoot> roots;
  bool complete = false;
  int boxes = 0; ///< looked at, for all points asked for together
};

/// What a point may cost, in about nanoseconds of one core.
inline constexpr std::int64_t kMaxWork = 4'500'000;
/// Where the halving of a box of high order alone costs a good part of that.
inline constexpr std::int64_t kMaxWorkOfHighOrders = 9'000'000;
/// A point that is looked for.
struct SoughtPoint
{
  Vec3 x{ 0.0 };
  /// Where Newton's iteration converged to, outside of the shape; NaN where it did not.
  Vec3 known{ std::numeric_limits<double>::quiet_NaN() };
  std::int64_t mostWork = kMaxWork;
};

enum class Wanted : std::uint8_t
{
  First, ///< one preimage is enough
  All
};

/// The certified inverse of an element's map: asks the element's tree for the preimages of at most
/// kGroupPoints points, best neighbours, at once.
///
/// A box is left behind where its frame excludes the point, or where the map is regular
/// (injective) on it and the one root that it can hold is known. Newton's iteration finds the
/// roots. See Module/Documentation/element-tree.md.
///
/// The answer for a point depends on that point and the element alone: not on the points asked
/// with it, nor on what the tree was asked before. Work is counted as if the tree had to be grown
/// for the point; what takes more than it may (`mostWork`) is unknown.
void FindPreimages(ElementTree& tree, std::span<const SoughtPoint> points, Wanted wanted,
  std::span<Preimages> answers);
} // namespace pixelexact
