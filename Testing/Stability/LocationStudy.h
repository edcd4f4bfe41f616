// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Stability/Cases.h"
#include "Stability/Report.h"

namespace pixelexact::testing
{
/// Locates points of which it is known where they are, and compares verdict, xi and the value of a
/// field with the reference.
///
/// Points of the element: Phi(xi) in Quad, rounded to double; the reference's preimage is that of
/// the rounded point. Points known to be outside: the same with xi beyond a face, where Phi is
/// injective, if they are farther out than twice the tolerance at faces (element-tree.md) explains.
///
/// Allowed errors, u = 2^-53, to first order:
///   |Phi(xi) - y|  <= B + u |y| + |J| (u |xi| + last correction's error),
///   |xi - xi_ref|  <= |J^-1| (B + u |y|) + u |xi| + last correction's error,
/// B the rounding of Phi's evaluation (RoundingTape.h). The last correction r is made with a
/// Jacobian a step of at most 1e-7 old, so that it errs by (1e-7 |J^-1| |D^2 Phi| + 16 u |J^-1|
/// |J|) r. Where the map is so curved that this bound is a quarter of the distance at which
/// Newton's iteration is sure to converge, the problem is not one of first order: there the first
/// of the two is asked for alone, and the value is compared at the xi found.
Row StudyLocation(const LocationCase& subject, int insidePoints, int outsidePoints,
  std::vector<ScatterPoint>* scatter = nullptr);
} // namespace pixelexact::testing
