// SPDX-License-Identifier: BSD-3-Clause
// f along a ray, through a piece's map, as a quadratic of one variable.
#if defined(PIXELEXACT_RAY_QUADRATIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_RAY_QUADRATIC_INL_H
#undef PIXELEXACT_RAY_QUADRATIC_INL_H
#else
#define PIXELEXACT_RAY_QUADRATIC_INL_H
#endif

#include "Trace/Surfaces/Curved/CurvedEquations-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Least sine, in xi, of the angle between the two planes whose intersection is the ray. Above it,
/// the line is known to some 1e-12.
constexpr double kMinSine = 1e-4;
/// Bound of the rounding of numbers that the line is computed from.
constexpr double kLineRounding = 1e-11;
/// Least slope of a root, relative to f's slope, so that the root's place is known to some 1e-12.
/// If the ray's other root is not found, the piece is subdivided, and this root is found a second
/// time at the same place.
constexpr double kMinSlope = 1e-3;
/// Largest error of a slope, relative to the slope, that still proves at most one root.
constexpr double kMaxOfSlope = 0.8;

/// A symmetric matrix: the diagonal, then 01, 12, 20.
struct SymmetricLanes
{
  Lanes m[6];

  HWY_INLINE void Times(const Lanes (&x)[3], Lanes (&to)[3]) const
  {
    to[0] = m[0] * x[0] + m[3] * x[1] + m[5] * x[2];
    to[1] = m[3] * x[0] + m[1] * x[1] + m[4] * x[2];
    to[2] = m[5] * x[0] + m[4] * x[1] + m[2] * x[2];
  }
  HWY_INLINE void TimesAbs(const Lanes (&x)[3], Lanes (&to)[3]) const
  {
    const SymmetricLanes size{ { Abs(m[0]), Abs(m[1]), Abs(m[2]), Abs(m[3]), Abs(m[4]),
      Abs(m[5]) } };
    size.Times(x, to);
  }
};

HWY_INLINE Lanes Dot(const Lanes (&a)[3], const Lanes (&b)[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
HWY_INLINE Lanes DotAbs(const Lanes (&a)[3], const Lanes (&b)[3])
{
  return Abs(a[0]) * b[0] + Abs(a[1]) * b[1] + Abs(a[2]) * b[2];
}
HWY_INLINE void Cross(const Lanes (&a)[3], const Lanes (&b)[3], Lanes (&to)[3])
{
  to[0] = a[1] * b[2] - a[2] * b[1];
  to[1] = a[2] * b[0] - a[0] * b[2];
  to[2] = a[0] * b[1] - a[1] * b[0];
}

/// The equations at a point, in the element's units: across the ray g_a = y_a - s_a y_k - q_a, and
/// f; their slopes and second derivatives, and the errors of these.
struct RayPoint
{
  Lanes g[3];
  Lanes rounding[3];
  Lanes m[3][3];
  SymmetricLanes curve[3];
  Lanes rest[3][3];
};

/// The part of a ray on which roots may lie, and whether it has at most one root.
struct RayStretch
{
  Lanes from;
  Lanes to;
  Lanes root; ///< expected place of the root
  LaneMask isThere;
  LaneMask isUnique;
};

/// A ray in xi, relative to the point: off = u e + c, with an error of at most `spread`, and f = A
/// + B u + K/2 u^2, with an error of at most `error`, for roots inside a box. u is e . off.
///
/// `off` obeys two equations across the ray. Their linear parts, with the inverse of their matrix
/// and e, give u e and the constant part. Their quadratic parts are moved to f: the coefficients,
/// times f's slopes across, are subtracted from those of f.
class RayQuadratic
{
public:
  HWY_INLINE RayQuadratic(const RayPoint& at, const RootBox& box)
  {
    Lanes middle[3];
    Lanes radius[3];
    Lanes largest[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        middle[d] = Splat(0.5) * (box.lower[d] + box.upper[d]);
        radius[d] = Splat(0.5) * (box.upper[d] - box.lower[d]) + Splat(1e-15);
        largest[d] = Abs(middle[d]) + radius[d];
      });
    // e, and the columns of the inverse that belong to the two equations.
    Lanes normal[3];
    Cross(at.m[0], at.m[1], normal);
    const Lanes square = Dot(normal, normal);
    const Lanes sizes = Dot(at.m[0], at.m[0]) * Dot(at.m[1], at.m[1]);
    isValid = And(IsFinite(sizes), sizes * Splat(kMinSine * kMinSine) < square);
    const Lanes inverse = Splat(1.0) / Sqrt(square);
    Lanes column[2][3];
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { e[d] = normal[d] * inverse; });
    Cross(at.m[1], e, column[0]);
    Cross(e, at.m[0], column[1]);
    for (auto& one : column)
    {
      ForEachAxis([&](auto d) PIXELEXACT_INLINED { one[d] = one[d] * inverse; });
    }
    const Lanes(&slope)[3] = at.m[2];
    const Lanes lambda[2] = { Dot(slope, column[0]), Dot(slope, column[1]) };
    SymmetricLanes L;
    for (std::size_t n = 0; n < 6; ++n)
    {
      L.m[n] = at.curve[2].m[n] - lambda[0] * at.curve[0].m[n] - lambda[1] * at.curve[1].m[n];
    }
    // The ray to second order at the box's middle, its deviation in the box, and its turn between
    // two roots.
    Lanes c[3];
    Lanes turns[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        c[d] = Splat(0.0) - column[0][d] * at.g[0] - column[1][d] * at.g[1];
        centre[d] = c[d];
        spread[d] = Splat(1e-14);
        turns[d] = Splat(0.0);
      });
    const Lanes size[3] = { Abs(e[0]), Abs(e[1]), Abs(e[2]) };
    Lanes slopes[2][3];
    Lanes along[2];
    for (std::size_t a = 0; a < 2; ++a)
    {
      Lanes turned[3];
      Lanes around[3];
      at.curve[a].Times(middle, turned);
      at.curve[a].TimesAbs(radius, around);
      const Lanes second = Splat(0.5) * Dot(turned, middle);
      const Lanes off = DotAbs(turned, radius) + Splat(0.5) * Dot(around, radius) +
        Dot(at.rest[a], largest) + at.rounding[a];
      ForEachAxis([&](auto d) PIXELEXACT_INLINED
        { slopes[a][d] = Abs(turned[d]) + around[d] + at.rest[a][d] + Splat(1e-15); });
      along[a] = Dot(slopes[a], size);
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED
        {
          const Lanes by = Abs(column[a][d]);
          centre[d] = centre[d] - column[a][d] * second;
          spread[d] = spread[d] + by * off;
          turns[d] = turns[d] + by * along[a];
        });
    }
    Lanes Le[3];
    Lanes Lc[3];
    L.Times(e, Le);
    L.Times(centre, Lc);
    A = at.g[2] + Dot(slope, c) + Splat(0.5) * Dot(centre, Lc);
    B = Dot(slope, e) + Dot(centre, Le);
    K = Dot(e, Le);
    // The box's part of the line, in u.
    from = Splat(-4.0);
    to = Splat(4.0);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        spread[d] = spread[d] * Splat(kMore) + Splat(kLineRounding) * (Abs(centre[d]) + largest[d]);
        const Lanes low = box.lower[d] - centre[d] - spread[d];
        const Lanes high = box.upper[d] - centre[d] + spread[d];
        const LaneMask crosses = Splat(1e-9) < Abs(e[d]);
        const Lanes by = Splat(1.0) / Select(crosses, e[d], Splat(1.0));
        const Lanes p = Select(crosses, low * by, from);
        const Lanes q = Select(crosses, high * by, to);
        from = Max(from, Min(p, q) - Splat(1e-14));
        to = Min(to, Max(p, q) + Splat(1e-14));
      });
    Lanes most[3];
    Lanes curved[3];
    L.TimesAbs(spread, curved);
    Lanes rest[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        most[d] = Max(Abs(Lc[d] + from * Le[d]), Abs(Lc[d] + to * Le[d]));
        rest[d] = at.rest[2][d] + Abs(lambda[0]) * at.rest[0][d] + Abs(lambda[1]) * at.rest[1][d];
      });
    const Lanes known =
      at.rounding[2] + Abs(lambda[0]) * at.rounding[0] + Abs(lambda[1]) * at.rounding[1];
    const Lanes reach = Max(Abs(from), Abs(to));
    Lanes around[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED { around[d] = Abs(c[d]) + Abs(centre[d]) + size[d] * reach; });
    error = (Dot(most, spread) + Splat(0.5) * Dot(curved, spread) + Dot(rest, largest) + known) *
        Splat(kMore) +
      Splat(kLineRounding) * (Abs(at.g[2]) + DotAbs(slope, around) + Dot(most, around));
    // The difference of two roots is a multiple of e plus `turned`. The turn of the ray itself
    // contributes to `turned`.
    const Lanes again = Max(Dot(slopes[0], turns) / along[0], Dot(slopes[1], turns) / along[1]);
    isValid = And(isValid, again <= Splat(0.9));
    const Lanes more = Splat(kMore) / (Splat(1.0) - again);
    Lanes turned[3];
    Lanes way[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        turned[d] = turns[d] * more;
        way[d] = size[d] + turned[d];
        curved[d] = most[d] + curved[d];
      });
    slopeError = (DotAbs(Le, spread) + Dot(curved, turned) + Dot(rest, way)) * Splat(kMore) +
      Splat(kMinSlope) * (Abs(slope[0]) + Abs(slope[1]) + Abs(slope[2]));
    isValid = And(isValid, IsFinite(A + B + K + error + slopeError));
  }

  /// The stretches before and after the vertex of the parabola.
  HWY_INLINE void Split(RayStretch& before, RayStretch& behind) const
  {
    const Lanes zero = Splat(0.0);
    // Mirrored so that the parabola opens upwards.
    const LaneMask isDown = K < zero;
    const Lanes a = Select(isDown, zero - A, A);
    const Lanes b = Select(isDown, zero - B, B);
    const Lanes k = Max(Abs(K), Splat(1e-280));
    const Lanes vertex = (zero - b) / k;
    const auto at = [&](Lanes u) PIXELEXACT_INLINED { return a + u * (b + Splat(0.5) * k * u); };
    const Lanes lowest = Max(Min(vertex, to), from);
    const auto isAbove = at(lowest) <= error;
    const Lanes less = zero - error;
    const LaneMask may = And(from <= to, isAbove);
    before.isThere = And(may, And(from < vertex, less <= at(from)));
    behind.isThere = And(may, And(vertex < to, less <= at(to)));
    // The points where the parabola has the value `level`, on both sides.
    const auto crossings = [&](Lanes level, Lanes& lower, Lanes& upper) PIXELEXACT_INLINED
    {
      const Lanes c = a - level;
      const Lanes root = Sqrt(Max(b * b - Splat(2.0) * k * c, zero));
      const Lanes sum = Max(Abs(b) + root, Splat(1e-290));
      const Lanes far = sum / k;
      const Lanes near = Splat(2.0) * c / sum;
      const LaneMask rises = zero < b;
      lower = Select(rises, zero - far, near);
      upper = Select(rises, zero - near, far);
      return root;
    };
    Lanes lower;
    Lanes upper;
    const Lanes slack = Splat(1e-14) + Splat(kLineRounding) * (Abs(from) + Abs(to));
    crossings(error, lower, upper);
    before.from = Max(from, lower - slack);
    behind.to = Min(to, upper + slack);
    crossings(less, lower, upper);
    before.to = Max(Min(Min(lower, vertex) + slack, to), from);
    behind.from = Min(Max(Max(upper, vertex) - slack, from), to);
    crossings(zero, lower, upper);
    before.root = Max(Min(lower, before.to), before.from);
    behind.root = Max(Min(upper, behind.to), behind.from);
    const auto isSteep = [&](Lanes slope) PIXELEXACT_INLINED
    { return And(isValid, slopeError <= Splat(kMaxOfSlope) * slope); };
    before.isUnique = isSteep(zero - b - k * before.to);
    behind.isUnique = isSteep(b + k * behind.from);
  }

  /// Restricts a box to a stretch. Returns the lanes where nothing remains.
  HWY_INLINE LaneMask Keep(const RayStretch& stretch, RootBox& box) const
  {
    LaneMask empty = stretch.to < stretch.from;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const Lanes p = stretch.from * e[d];
        const Lanes q = stretch.to * e[d];
        box.lower[d] = Max(box.lower[d], centre[d] + Min(p, q) - spread[d]);
        box.upper[d] = Min(box.upper[d], centre[d] + Max(p, q) + spread[d]);
        empty = Or(empty, box.upper[d] < box.lower[d]);
      });
    return empty;
  }

  Lanes e[3];
  Lanes centre[3];
  Lanes spread[3];
  Lanes A;
  Lanes B;
  Lanes K;
  Lanes error;
  Lanes slopeError;
  Lanes from;
  Lanes to;
  LaneMask isValid;
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
