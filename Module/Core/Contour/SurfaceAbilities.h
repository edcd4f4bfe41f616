// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

namespace pixelexact
{
/// The uses of a cut-surface other than pictures.
enum class SurfaceUse
{
  Lines,     ///< contours as certified polylines
  Integrals, ///< with proven errors
  Clips      ///< the surface ends others
};

/// A kind of cut-surface and its uses. The page `options.md` contains this table.
struct SurfaceAbility
{
  const char* plural;
  const char* vtkClass; ///< empty: none
  const char* option;   ///< of the tool; empty: none
  int degree;           ///< of its polynomial; 0: it has none
  bool lines;
  bool integrals;
  bool clips;

  [[nodiscard]] bool Has(SurfaceUse use) const
  {
    return use == SurfaceUse::Lines ? lines : use == SurfaceUse::Integrals ? integrals : clips;
  }
};

std::span<const SurfaceAbility> SurfaceAbilities();

/// Names the surfaces that have a use: the part of an error's message that follows the name of the
/// surface without it, with the remedy.
std::string DescribeSurfacesWith(SurfaceUse use);
} // namespace pixelexact
