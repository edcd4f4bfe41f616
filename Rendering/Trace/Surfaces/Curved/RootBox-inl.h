// SPDX-License-Identifier: BSD-3-Clause
// Boxes in a piece that contain the roots of rays.
#if defined(PIXELEXACT_ROOT_BOX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_ROOT_BOX_INL_H
#undef PIXELEXACT_ROOT_BOX_INL_H
#else
#define PIXELEXACT_ROOT_BOX_INL_H
#endif

#include "Core/Element/Matrix-inl.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/PieceProof-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A box of xi, relative to a piece's centre, that contains the roots of rays.
struct RootBox
{
  Lanes lower[3];
  Lanes upper[3];
};

/// Restricts a box to the piece, in directions that collapse: there the ends depend on the xi after
/// them. Returns the lanes where nothing remains.
HWY_INLINE LaneMask KeepToPiece(Shape shape, const CurvedPiece& piece, RootBox& box)
{
  const Lanes half = Splat(0.5);
  const auto lowest = [&](int d) PIXELEXACT_INLINED
  { return Splat(piece.centre[d]) + box.lower[d]; };
  const auto highest = [&](int d) PIXELEXACT_INLINED
  { return Splat(piece.centre[d]) + box.upper[d]; };
  LaneMask empty = half < Splat(0.0);
  const auto keep = [&](int d, Lanes most, Lanes least) PIXELEXACT_INLINED
  {
    const Lanes from = Splat(1.0 + piece.centre[d]);
    const Lanes none = Splat(0.0);
    box.upper[d] =
      Min(box.upper[d], Splat(1.0 + piece.box.upper[d]) * Max(most, none) - from + Splat(kSlack));
    box.lower[d] =
      Max(box.lower[d], Splat(1.0 + piece.box.lower[d]) * Max(least, none) - from - Splat(kSlack));
    empty = Or(empty, box.upper[d] < box.lower[d]);
  };
  const Lanes most = half * (Splat(1.0) - lowest(2));
  const Lanes least = half * (Splat(1.0) - highest(2));
  if (shape == Shape::Tetrahedron || shape == Shape::Pyramid)
  {
    keep(1, most, least);
  }
  if (shape == Shape::Tetrahedron)
  {
    const Lanes zero = Splat(0.0);
    keep(0, half * (zero - lowest(1) - lowest(2)), half * (zero - highest(1) - highest(2)));
  }
  else
  {
    keep(0, most, least);
  }
  return empty;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
