// SPDX-License-Identifier: BSD-3-Clause
// Functions shared by tests of pieces and Newton's iteration in them.
#if defined(PIXELEXACT_PIECE_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PIECE_MATH_INL_H
#undef PIXELEXACT_PIECE_MATH_INL_H
#else
#define PIXELEXACT_PIECE_MATH_INL_H
#endif

#include "Core/Element/Matrix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Largest count of Newton's steps in a piece.
constexpr double kMaxRounds = 40.0;
/// Largest distance in xi from a piece that counts as rounding.
constexpr double kEdge = 1e-15;

/// Clamps a xi outside a piece to the piece: along each direction of eta in turn, from the last to
/// the first, the nearest point.
HWY_INLINE void ClampTo(Shape shape, const Lanes (&lower)[3], const Lanes (&upper)[3],
  const Lanes (&xi)[3], Lanes (&x)[3])
{
  const Lanes one = Splat(1.0);
  const Lanes half = Splat(0.5);
  const auto clampTo = [&](int d, Lanes extent) PIXELEXACT_INLINED
  { return Max(Min(xi[d], (one + upper[d]) * extent - one), (one + lower[d]) * extent - one); };
  x[2] = Max(Min(xi[2], upper[2]), lower[2]);
  const Lanes narrow = half * (one - x[2]);
  x[1] = clampTo(1, shape == Shape::Tetrahedron || shape == Shape::Pyramid ? narrow : one);
  x[0] = clampTo(0,
    shape == Shape::Hexahedron      ? one
      : shape == Shape::Tetrahedron ? half * (Splat(0.0) - x[1] - x[2])
                                    : narrow);
}

/// Newton's iteration has converged, up to rounding, after a step at most this large.
constexpr double kArrived = 1e-8;

/// N equations hold up to rounding or, if a step would leave the element, up to the element's
/// uncertainty, because the neighbour's boundary is within it.
template <std::size_t N>
struct Closeness
{
  HWY_INLINE Closeness(const Lanes (&g)[N], double rounding, double uncertainty, LaneMask leaves)
  {
    Lanes largest = Abs(g[0]);
    ForEachUpTo(Const<static_cast<int>(N) - 2>(),
      [&](auto n) PIXELEXACT_INLINED { largest = Max(largest, Abs(g[n + 1])); });
    tolerance = Select(leaves, Splat(uncertainty), Splat(rounding));
    isExact = largest <= Splat(rounding);
    isNear = largest <= tolerance;
  }
  Lanes tolerance;
  LaneMask isExact;
  LaneMask isNear;
};

/// The inverse; not finite if there is none.
HWY_INLINE void InverseOf(const Lanes (&m)[3][3], Lanes (&inverse)[9])
{
  const auto minor = [&](int r0, int c0, int r1, int c1) PIXELEXACT_INLINED
  { return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]; };
  inverse[0] = minor(1, 1, 2, 2);
  inverse[1] = minor(0, 2, 2, 1);
  inverse[2] = minor(0, 1, 1, 2);
  inverse[3] = minor(1, 2, 2, 0);
  inverse[4] = minor(0, 0, 2, 2);
  inverse[5] = minor(0, 2, 1, 0);
  inverse[6] = minor(1, 0, 2, 1);
  inverse[7] = minor(0, 1, 2, 0);
  inverse[8] = minor(0, 0, 1, 1);
  const Lanes scale =
    Splat(1.0) / (m[0][0] * inverse[0] + m[0][1] * inverse[3] + m[0][2] * inverse[6]);
  for (Lanes& v : inverse)
  {
    v = v * scale;
  }
}

HWY_INLINE void Product(const Lanes (&m)[9], const Lanes (&v)[3], Lanes (&to)[3])
{
  ForEachAxis([&](auto r) PIXELEXACT_INLINED
    { to[r] = m[3 * r] * v[0] + m[3 * r + 1] * v[1] + m[3 * r + 2] * v[2]; });
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
