// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Tree/TreeKernels.h"

#include <array>
#include <span>

namespace pixelexact
{
/// The check of a xi as a root of y.
struct RootCheck
{
  [[nodiscard]] bool IsOnFace(Shape shape, const Vec3& xi) const
  {
    return !(Margin(shape, xi) > tolerance.x + tolerance.y + tolerance.z);
  }

  Vec3 tolerance{ 0.0 }; ///< the faces': |J^-1| times the uncertainty; zero where J is singular
  bool holds = false;    ///< Phi(xi) is y up to so many times the uncertainty
};

/// Checks at most kGroupPoints roots at once.
class RootChecker
{
public:
  explicit RootChecker(const InverseProblem& problem)
    : Problem(problem)
  {
  }

  void Run(std::span<const Vec3> xi, std::span<const Vec3> y, std::span<RootCheck> checks,
    double mostMiss = kMaxMiss);

private:
  const InverseProblem& Problem;
  /// xi, Phi, its derivatives and y, coordinate by coordinate. The tolerance later replaces xi.
  alignas(64) std::array<std::array<double, kGroupPoints>, 18> Lanes;
};

/// Whether xi lies within the faces' tolerance of a face: |J^-1| times the uncertainty of Phi and
/// y; true where J is singular.
bool IsOnFace(const InverseProblem& problem, const Vec3& xi);

/// Whether xi lies on the face of a surface in space (ShellFace), within the tolerance with which
/// roots beyond it are accepted: kMaxMiss times the faces' tolerance.
bool IsOnShell(const InverseProblem& problem, const Vec3& xi);
} // namespace pixelexact
