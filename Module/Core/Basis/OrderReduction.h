// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pixelexact
{
/// Finds the trailing orders of an element's map that are noise from its coordinates' roundings, by
/// the rule in OrderReduction.cxx. Refers to its arguments.
class OrderReduction
{
public:
  /// `amplification`: per mode, the factor by which roundings of nodes grow. `modes`: those of the
  /// map's three components, one after the other. `size`: that of the element. Both are in world
  /// units. `roundings`: of the coordinates, world units. `noise`: how far one unit of rounding may
  /// move the map.
  OrderReduction(const Space& space, std::span<const double> amplification,
    std::span<const double> modes, double roundings, double noise, double size);

  /// Whether all modes are noise.
  [[nodiscard]] bool IsNoise() const;
  /// The space without the orders that are noise.
  [[nodiscard]] Space Reduce() const;
  /// Bound of the distance of the map in `kept` from the true map, in world units.
  [[nodiscard]] double Uncertainty(const Space& kept) const;

  /// The modes of the kept space, times a factor, component by component.
  [[nodiscard]] std::vector<double> Keep(const Space& kept, double factor) const;

  /// Whether `space` has a mode.
  static bool Has(const Space& space, int p, int q, int r)
  {
    return p <= space.order[0] && q <= space.LastQ(p) && r <= space.LastR(p, q);
  }

private:
  [[nodiscard]] double At(int component, int mode) const
  {
    return Modes[static_cast<std::size_t>(component) * Amplification.size() + mode];
  }
  /// Whether rounding explains a mode.
  [[nodiscard]] bool IsExplained(int mode) const;
  /// Whether the modes that are not kept are noise.
  template <class Keeps>
  [[nodiscard]] bool IsNoise(const Keeps& keeps) const;
  /// Lowers `kept` by the last order of these directions where it is noise. Returns whether it was.
  bool Drop(std::span<const int> directions, Space& kept) const;

  Space Full;
  std::span<const double> Amplification;
  std::span<const double> Modes;
  double Roundings;
  double Noise;
  double Size;
  std::array<int, 3> Needed{}; ///< orders below these drop a mode that is no noise
};
} // namespace pixelexact
