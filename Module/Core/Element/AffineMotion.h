// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <array>
#include <optional>
#include <span>

namespace pixelexact
{
/// x becomes to + matrix (x - from).
struct AffineMotion
{
  std::array<std::array<long double, 3>, 3> matrix{};
  std::array<long double, 3> from{};
  std::array<long double, 3> to{};

  [[nodiscard]] std::array<long double, 3> Apply(const Vec3& x) const;
  /// A bound of the factor by which the motion stretches a vector.
  [[nodiscard]] double Stretch() const;
};

/// The affine motion of points to as many others, with the least sum of squared distances. None
/// where the points lie in a plane.
[[nodiscard]] std::optional<AffineMotion> FitMotion(
  std::span<const Vec3> points, std::span<const Vec3> moved);
} // namespace pixelexact
