// SPDX-License-Identifier: BSD-3-Clause
// Bounds on the roots of rays in a piece from second derivatives.
#if defined(PIXELEXACT_CURVED_EQUATIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_CURVED_EQUATIONS_INL_H
#undef PIXELEXACT_CURVED_EQUATIONS_INL_H
#else
#define PIXELEXACT_CURVED_EQUATIONS_INL_H
#endif

#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/RootBox-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The second derivatives of a piece that curves, as doubles.
struct Curvature
{
  double curve[4][6];
  double shift[4][3];
  double rest[4][3];

  explicit Curvature(const CurvedPiece& piece)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      std::copy_n(piece.curve[c], 6, curve[c]);
      std::copy_n(piece.shift[c], 3, shift[c]);
      std::copy_n(piece.rest[c], 3, rest[c]);
    }
  }
};

/// The equations times M^-1, to second order: first + off + 1/2 off^T P off, with an error of at
/// most `error` and a remainder that grows with `off`.
struct CurvedEquations
{
  Lanes first[3];
  Lanes error[3];
  Lanes P[3][6];
  Lanes rest[3][3];

  HWY_INLINE CurvedEquations(const Curvature& piece, const std::size_t (&across)[2], std::size_t k,
    const Lanes (&slope)[2], const Lanes (&inverse)[9], const Lanes (&step)[3],
    const Lanes (&off)[3])
  {
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        first[r] = step[r];
        error[r] = off[r];
        const Lanes a = inverse[3 * r];
        const Lanes b = inverse[3 * r + 1];
        const Lanes c = inverse[3 * r + 2];
        const Lanes along = a * slope[0] + b * slope[1];
        const Lanes far = Abs(a) * Abs(slope[0]) + Abs(b) * Abs(slope[1]);
        for (std::size_t n = 0; n < 6; ++n)
        {
          P[r][n] = a * Splat(piece.curve[across[0]][n]) + b * Splat(piece.curve[across[1]][n]) +
            c * Splat(piece.curve[3][n]) - along * Splat(piece.curve[k][n]);
        }
        ForEachAxis(
          [&](auto d) PIXELEXACT_INLINED
          {
            rest[r][d] = Abs(a) * Splat(piece.rest[across[0]][d]) +
              Abs(b) * Splat(piece.rest[across[1]][d]) + Abs(c) * Splat(piece.rest[3][d]) +
              far * Splat(piece.rest[k][d]);
          });
      });
  }

  /// The product of equation r's matrix P and a vector.
  HWY_INLINE void Times(int r, const Lanes (&x)[3], Lanes (&to)[3]) const
  {
    const Lanes(&p)[6] = P[r];
    to[0] = p[0] * x[0] + p[3] * x[1] + p[5] * x[2];
    to[1] = p[3] * x[0] + p[1] * x[1] + p[4] * x[2];
    to[2] = p[5] * x[0] + p[4] * x[1] + p[2] * x[2];
  }

  /// Narrows a box to the part that may contain a root. Returns the lanes where nothing remains.
  /// `start`: the root to second order.
  HWY_INLINE LaneMask Narrow(RootBox& box, Lanes (&start)[3]) const
  {
    const Lanes half = Splat(0.5);
    Lanes middle[3];
    Lanes radius[3];
    Lanes largest[3];
    MiddleOf(box, middle, radius, largest);
    LaneMask empty = half < Splat(0.0);
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        const Lanes(&p)[6] = P[r];
        Lanes turned[3];
        Times(r, middle, turned);
        const Lanes at = Splat(0.0) - first[r] -
          half * (turned[0] * middle[0] + turned[1] * middle[1] + turned[2] * middle[2]);
        const Lanes mixed = Abs(p[3]) * (radius[0] * radius[1]) +
          Abs(p[4]) * (radius[1] * radius[2]) + Abs(p[5]) * (radius[2] * radius[0]);
        Lanes less = error[r] + mixed;
        Lanes more = less;
        ForEachAxis(
          [&](auto d) PIXELEXACT_INLINED
          {
            const Lanes linear = Abs(turned[d]) * radius[d] + rest[r][d] * largest[d];
            const Lanes square = half * p[d] * (radius[d] * radius[d]);
            less = less + linear + Max(square, Splat(0.0));
            more = more + linear - Min(square, Splat(0.0));
          });
        start[r] = at;
        const Lanes slack = Splat(1e-14) + Splat(1e-9) * (Abs(at) + less + more);
        box.lower[r] = Max(box.lower[r], at - less - slack);
        box.upper[r] = Min(box.upper[r], at + more + slack);
        empty = Or(empty, box.upper[r] < box.lower[r]);
      });
    return empty;
  }

  /// Largest deviation of the derivatives from the unit matrix in a box.
  HWY_INLINE void Spread(const RootBox& box, Lanes (&K)[3][3]) const
  {
    Lanes middle[3];
    Lanes radius[3];
    Lanes largest[3];
    MiddleOf(box, middle, radius, largest);
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        const Lanes(&p)[6] = P[r];
        Times(r, middle, K[r]);
        K[r][0] = Abs(K[r][0]) + rest[r][0] + Abs(p[0]) * radius[0] + Abs(p[3]) * radius[1] +
          Abs(p[5]) * radius[2];
        K[r][1] = Abs(K[r][1]) + rest[r][1] + Abs(p[3]) * radius[0] + Abs(p[1]) * radius[1] +
          Abs(p[4]) * radius[2];
        K[r][2] = Abs(K[r][2]) + rest[r][2] + Abs(p[5]) * radius[0] + Abs(p[4]) * radius[1] +
          Abs(p[2]) * radius[2];
      });
  }

private:
  static HWY_INLINE void MiddleOf(
    const RootBox& box, Lanes (&middle)[3], Lanes (&radius)[3], Lanes (&largest)[3])
  {
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        middle[d] = Splat(0.5) * (box.lower[d] + box.upper[d]);
        radius[d] = Splat(0.5) * (box.upper[d] - box.lower[d]) + Splat(1e-15);
        largest[d] = Abs(middle[d]) + radius[d];
      });
  }
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
