// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Homogeneous expansions: Fourier's functions along z over a two-dimensional mesh, or along y and z
// over a one-dimensional one. Their elements become solids in layers, with polynomials along these
// directions that are proven to be near enough.
namespace pixelexact::nektar
{
/// Along a direction, from 0 to `length`: function 2 k is cos(2 pi k s / length), function 2 k + 1
/// is -sin(2 pi k s / length).
struct Periodic
{
  double length = 1.0;
  std::vector<int> functions; ///< those that there are, by number

  bool operator==(const Periodic&) const = default;
};

/// Of a complex wave along z a file may have one part alone. The real one is minus function 2, the
/// imaginary one function 3; the field "w" is always imaginary.
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
  bool strips = false; ///< of a length each, with gaps between them

  [[nodiscard]] std::size_t Functions() const
  {
    return (y ? y->functions.size() : 1) * z.functions.size();
  }
  bool operator==(const Homogeneous&) const = default;
};

/// What a polynomial may lose, in parts of the field's range.
inline constexpr double kHomogeneousLoss = 1e-13;

/// A field: per strip, function of z and function of y, this one fastest, the coefficients on the
/// mesh's elements.
struct HomogeneousField
{
  std::string name;
  std::string basis;
  std::vector<OwnedExpansion> planes;
};

/// Makes the model of a slab one of layers, in place, with these fields; their coefficients are
/// taken. `begin`: where along z each strip begins, 0 alone without strips. An element of layer l,
/// those along y fastest, has l times (1 + the largest number) added to its number. Notes say how
/// many layers and which order there are, and what is lost at most.
void LiftHomogeneous(const Homogeneous& along, const std::vector<double>& begin,
  std::vector<HomogeneousField> fields, SolverModel& model);
} // namespace pixelexact::nektar
