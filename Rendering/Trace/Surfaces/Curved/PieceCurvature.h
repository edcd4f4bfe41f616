// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Math/Mat.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"

#include <array>
#include <span>

namespace pixelexact
{
/// No smaller; infinite where no finite float is.
float AboveFloat(double value);

/// How xi goes with eta over a piece: linear in each of its directions.
class PieceCorners
{
public:
  /// With centre and half of the piece known.
  PieceCorners(Shape shape, const CurvedPiece& piece);

  /// Second derivatives of function c, from its derivatives by xi (three, over the piece), and how
  /// far these are from what they say. False, and nothing set, where something is not finite.
  [[nodiscard]] bool SetCurvature(
    std::span<const BoxPolynomial> by, std::size_t c, CurvedPiece& piece) const;

private:
  std::array<Vec3, 8> Off; ///< xi at the corners, from the centre; bit d: the upper end along d
  Mat3 ToXi{ 0.0 };        ///< from derivatives by eta's way, -1 to 1, to those by xi
};
} // namespace pixelexact
