// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Location/ElementBounds.h"

namespace pixelexact
{
struct CarefulResult
{
  Verdict verdict = Verdict::Unknown;
  Vec3 xi{ 0.0 };
  double residual = 0.0;
};

/// Decides by subdivision whether an element holds a point: boxes of the tensor space whose
/// Bernstein hulls (plain, and seen through the inverse of the box's mean Jacobian) exclude the
/// point are dropped, Newton starts from the others, the rest is halved.
///
/// `Inside` and `Outside` carry the reasons that Verdict names: a converged inverse; hulls widened
/// by the element's uncertainty and their rounding. `Unknown` when the budget is spent. The place
/// of the certified engine for polynomial systems, which is to prove uniqueness too.
CarefulResult CarefulInverse(const Mesh& mesh, int element, const ElementBounds& bounds,
  const Vec3& x);
} // namespace pixelexact
