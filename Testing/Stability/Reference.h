// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Stability/Quad.h"

#include "Core/Element/Mesh.h"
#include "Core/Math/Vec.h"

#include <vector>

// Reference values in Quad, from the coefficients as they are stored.
namespace pixelexact::testing
{
struct QuadSample
{
  Quad value;
  QuadVec3 gradient; ///< by xi
};

QuadVec3 ToQuad(const Vec3& x);
Vec3 ToDouble(const QuadVec3& x);

/// Evaluates one component. `xi` must be in the shape or near it.
QuadSample Evaluate(const Space& space, const double* coefficients, const QuadVec3& xi);

/// sum |c| |mode|: what rounding is measured by.
Quad Magnitude(const Space& space, const double* coefficients, const QuadVec3& xi);

/// All modes, in order of storage.
std::vector<Quad> Modes(const Space& space, const QuadVec3& xi);

/// Margin of Shape.h.
Quad Margin(Shape shape, const QuadVec3& xi);

/// The point whose value the functions take at xi: a pyramid's are continued past its faces as
/// constants next to the apex (1e-8), where they are not smooth (Lanes-inl.h).
QuadVec3 Continued(Shape shape, const QuadVec3& xi);

/// The inverse by cofactors.
QuadMat3 Inverse(const QuadMat3& m);

/// Phi and its Jacobian in the element's own units.
struct QuadImage
{
  QuadVec3 y;
  QuadMat3 jacobian;
};
QuadImage MapInUnits(const Mesh& mesh, int element, const QuadVec3& xi);

/// Phi(xi) in world units, rounded once.
Vec3 MapToWorld(const Mesh& mesh, int element, const QuadVec3& xi);

/// y of a world point, exact.
QuadVec3 ToUnits(const Mesh& mesh, int element, const Vec3& x);

struct QuadPreimage
{
  QuadVec3 xi;
  QuadMat3 jacobian; ///< in the element's units
  QuadMat3 inverse;
  double lastStep = 0.0; ///< in xi, max norm
};

/// Newton's iteration from a xi that is known to be near the preimage.
QuadPreimage FindPreimage(const Mesh& mesh, int element, const Vec3& x, const QuadVec3& near);
} // namespace pixelexact::testing
