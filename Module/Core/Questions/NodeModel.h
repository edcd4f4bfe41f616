// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeNode.h"
#include "Core/Questions/Outline.h"

#include <optional>
#include <span>

namespace pixelexact
{
/// What of an outline in xi is in a node, or no farther beside it than `off`.
[[nodiscard]] Outline KeepDeep(const EdgeNode& node, const double (&off)[3], Outline outline);

/// A xi about which a region's preimages in a node are looked for, by its model, which it must
/// have, and without a kernel; nothing: proven that there are none. `images`: of the region's
/// corners by the affine map, xi = centre + M (y - origin); `besides`: by how much these may be
/// off.
[[nodiscard]] std::optional<Vec3> FindByModel(
  const EdgeNode& node, std::span<const Vec3> images, const double (&besides)[3]);
} // namespace pixelexact
