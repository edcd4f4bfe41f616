// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Homogeneous expansions: Fourier's functions along z over a two-dimensional mesh, or along y and z
// over a one-dimensional one. Their elements become solids in layers, with polynomials along these
// directions whose error is bounded.
namespace pixelexact::nektar
{
/// Functions along a direction, from 0 to `length`: function 2 k is cos(2 pi k s / length),
/// function 2 k + 1 is -sin(2 pi k s / length).
struct Periodic
{
  double length = 1.0;
  std::vector<int> functions; ///< numbers of the functions in the file

  bool operator==(const Periodic&) const = default;
};

/// A file may contain one part of a complex wave along z. The real part is minus function 2, the
/// imaginary part is function 3. The field "w" is always imaginary.
enum class HalfMode : std::uint8_t
{
  None,
  Real,
  Imaginary
};

struct Homogeneous
{
  std::optional<Periodic> y; ///< over a one-dimensional mesh
  Periodic z;
  HalfMode half = HalfMode::None;
  bool strips = false; ///< strips of a length each, with gaps between them

  [[nodiscard]] std::size_t Functions() const
  {
    return (y ? y->functions.size() : 1) * z.functions.size();
  }
  bool operator==(const Homogeneous&) const = default;
};

/// Largest loss of a polynomial, relative to the field's range.
inline constexpr double kHomogeneousLoss = 1e-13;

/// A field: the coefficients on the mesh's elements per strip, function of z and function of y, the
/// last one fastest.
struct HomogeneousField
{
  std::string name;
  std::string basis;
  std::vector<OwnedExpansion> planes;
};

/// Converts the model of a slab to layers, in place, with these fields; their coefficients are
/// moved. `begin`: where each strip begins along z, a single 0 without strips. An element of layer
/// l (layers along y fastest) gets l times (1 + the largest number) added to its number. Notes
/// state the number of layers, the orders and the largest loss.
void LiftHomogeneous(const Homogeneous& along, const std::vector<double>& begin,
  std::vector<HomogeneousField> fields, SolverModel& model);
} // namespace pixelexact::nektar
