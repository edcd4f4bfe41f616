// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Locator.h"

#include <span>

namespace pixelexact
{
/// How many elements of a mesh cover a point.
enum class Coverage : std::uint8_t
{
  None = 0, ///< no element holds the point, by proof: outside, or a gap
  /// One preimage, or several of which at most one is not on a face, as in a valid mesh.
  Once = 1,
  /// Two or more that are on no face: an overlap, or a fold within an element. Within the faces'
  /// tolerance of an overlap's own boundary, the answer is Once.
  Several = 2,
  Undecided = 3 ///< an element could not be decided
};

const char* Name(Coverage coverage);

struct Owners
{
  std::int32_t preimages = 0; ///< in all elements
  std::int32_t elements = 0;  ///< that hold the point
  Coverage coverage = Coverage::None;
};

/// Counts every preimage of each point, in parallel; `owners` has one entry per point. The answer
/// depends on point and mesh alone. Points with NaN or infinite coordinates have no owner.
void FindOwners(const Locator& locator, std::span<const Vec3> points, std::span<Owners> owners);

/// The same for points that lie close together, serially, for use inside a parallel loop.
void FindOwnersOfTile(
  const Locator& locator, std::span<const Vec3> points, std::span<Owners> owners);
} // namespace pixelexact
