// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeNode.h"
#include "Core/Questions/Outline.h"

#include <optional>
#include <span>

namespace pixelexact
{
/// Clips an outline in xi to the node enlarged by `off`.
[[nodiscard]] Outline KeepDeep(const EdgeNode& node, const double (&off)[3], Outline outline);

/// Finds a xi near a region's preimages in a node by the node's model, which must exist, without a
/// kernel. None is a proof that there are no preimages. `images`: of the region's corners by the
/// affine map, xi = centre + M (y - origin); `besides`: the errors of these.
[[nodiscard]] std::optional<Vec3> FindByModel(
  const EdgeNode& node, std::span<const Vec3> images, const double (&besides)[3]);
} // namespace pixelexact
