// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Homogeneous/Homogeneous.h"

#include <span>

// Expands Fourier's functions in Legendre's polynomials, layer by layer, by Rayleigh's expansion:
//   exp(i t x) = sum over n of (2 n + 1) i^n j_n(t) P_n(x),  |j_n(t)| <= t^n / (2 n + 1)!!

namespace pixelexact::nektar
{
class FourierLayers
{
public:
  /// Uses two layers for each period of the shortest wave.
  explicit FourierLayers(const Periodic& along);

  [[nodiscard]] int Layers() const { return Count; }
  [[nodiscard]] std::size_t Functions() const { return Along.functions.size(); }
  [[nodiscard]] double Length() const { return Along.length; }
  [[nodiscard]] double Half() const { return Along.length / (2 * Count); }
  [[nodiscard]] double Middle(int layer) const
  {
    return Along.length * (2 * layer + 1) / (2 * Count);
  }

  /// The value of a function (by its place in the list) at s.
  [[nodiscard]] double Value(std::size_t function, double s) const;
  /// A function's coefficient of P_n(x), n to kMaxOrder, x from -1 to 1 upwards in the layer.
  [[nodiscard]] double Coefficient(int layer, std::size_t function, int n) const;
  /// A bound of |function - polynomial of this order|, anywhere.
  [[nodiscard]] double Loss(std::size_t function, int order) const;

private:
  [[nodiscard]] int Wave(std::size_t function) const { return Along.functions[function] / 2; }
  /// The phase of wave k in half a layer.
  [[nodiscard]] long double Phase(int wave) const;

  Periodic Along;
  int Count = 1;
  std::vector<long double> Bessel; ///< j_n of each function's phase, n to kMaxOrder
};

/// Orders of polynomials, and a bound of their difference from a field.
struct Accuracy
{
  int orderY = 0;
  int orderZ = 0;
  double loss = 0.0;  ///< at most
  double range = 0.0; ///< at least
};

/// The least orders, or the highest, with a loss that is proven to be at most kHomogeneousLoss of
/// the range. `y` is null where the mesh is two-dimensional.
Accuracy AccuracyOf(const HomogeneousField& field, const FourierLayers* y, const FourierLayers& z);
} // namespace pixelexact::nektar
