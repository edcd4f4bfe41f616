// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Math/Vec.h"

#include <optional>

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

/// The faces' tolerance at xi: |J^-1| times the uncertainty of Phi and y, in each xi; zero where J
/// is singular.
Vec3 FaceTolerance(const InverseProblem& problem, const Vec3& xi);
/// Whether xi lies within that tolerance of a face.
bool IsOnFace(const InverseProblem& problem, const Vec3& xi);

/// Newton's iteration from `start`; nothing where it does not converge. `problem`: its frame is not
/// used.
std::optional<InverseRoot> FindInverseRoot(
  const InverseProblem& problem, const Vec3& x, const Vec3& start);
} // namespace pixelexact
