// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Math/Mat.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"

#include <array>
#include <span>

namespace pixelexact
{
/// The least float that is not below `value`; infinite if there is no finite one.
float AboveFloat(double value);

/// xi as a function of eta over a piece, linear in each direction of eta.
class PieceCorners
{
public:
  /// Centre and half-extents of the piece must be set.
  PieceCorners(Shape shape, const CurvedPiece& piece);

  /// Sets the second derivatives of function c from its three derivatives by xi over the piece, and
  /// their error. Returns false, and sets nothing, if a number is not finite.
  [[nodiscard]] bool SetCurvature(
    std::span<const BoxPolynomial> by, std::size_t c, CurvedPiece& piece) const;

private:
  std::array<Vec3, 8> Off; ///< xi at the corners minus the centre; bit d: the upper end along d
  Mat3 ToXi{ 0.0 }; ///< converts derivatives by the piece's coordinates in [-1, 1] to those by xi
};

/// Variation of the slopes over a piece, relative to the slopes: of a face's tangents and normal
/// or, with a field, of the map and of the field's gradient. Infinite if there is no Jacobian,
/// gradient or normal to compare with.
[[nodiscard]] double BendOf(const CurvedPiece& piece, bool hasField);
} // namespace pixelexact
