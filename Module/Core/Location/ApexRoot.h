// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/RootCheck.h"
#include "Core/Tree/NodeFrame.h"

namespace pixelexact
{
/// Next to a pyramid's apex, the root, or the xi of the pyramid next to it.
struct ApexRoot
{
  Vec3 xi{ 0.0 };
  double moved = 0.0; ///< how far xi was moved into the pyramid, max norm
  RootCheck check;    ///< holds where the box's enclosure holds xi, too
};

/// Next to a pyramid's apex there is no root beyond the faces to be held against the tolerance.
/// Where it is all that keeps a box from excluding the point, the point is within it.
bool IsAtApex(Shape shape, const NodeFrame& frame);

/// Finds the root of y by Newton's iteration with a Jacobian of its own. The box's Jacobian belongs
/// to a box that is wide as seen from the apex, and may lead away. A root outside the box's
/// enclosure says nothing about the box.
ApexRoot RootAtApex(
  const InverseProblem& problem, RootChecker& checker, const NodeFrame& frame, const Vec3& y);
} // namespace pixelexact
