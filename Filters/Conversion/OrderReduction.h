// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrderReduction_h
#define OrderReduction_h

#include "Core/Basis/Space.h"

#include <array>
#include <span>

namespace pixelexact
{
/// Which trailing orders of an element's map are noise of its coordinates' roundings (the rule
/// stands in the source). Refers to what it is made of.
class OrderReduction
{
public:
  /// `amplification`: by mode, by which roundings of nodes grow. `modes`: of the map's three
  /// components, one after the other, and `size`, of the element: world units. `roundings`: of the
  /// coordinates, world units; `noise`: how far one unit of them may move the map.
  OrderReduction(const Space& space, std::span<const double> amplification,
    std::span<const double> modes, double roundings, double noise, double size);

  /// Whether nothing but noise is there.
  [[nodiscard]] bool IsNoise() const;
  /// The space without the orders that are noise.
  [[nodiscard]] Space Reduce() const;
  /// World units: how far the map in `kept` may be from the true one.
  [[nodiscard]] double Uncertainty(const Space& kept) const;

  /// Whether `space` has a mode.
  static bool Has(const Space& space, int p, int q, int r);

private:
  [[nodiscard]] double At(int component, int mode) const;
  /// Whether rounding explains a mode.
  [[nodiscard]] bool IsExplained(int mode) const;
  /// Whether the modes that are not kept are noise.
  template <class Keeps>
  [[nodiscard]] bool IsNoise(const Keeps& keeps) const;
  /// Takes the last order of these directions from `kept` where it is noise, and tells whether.
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
#endif
