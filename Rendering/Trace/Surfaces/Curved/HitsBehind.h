// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/BehindFace.h"
#include "Trace/Surfaces/Curved/PieceSolver.h"

#include <vector>

namespace pixelexact
{
/// FindBehind at the hits of a face from number `first` on, one result per hit.
std::vector<BehindFace> HitsBehind(const Locator& locator, const CurvedPart& part,
  const std::vector<CurvedHit>& hits, std::size_t first);
} // namespace pixelexact
