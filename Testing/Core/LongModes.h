// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Recurrence.h"
#include "Core/Basis/Space.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pixelexact::testing
{
/// The canonical modes in long double (64 bits of mantissa), or in numbers that carry derivatives
/// (LongDual.h). They share nothing with the kernels but the recurrence's coefficients. Points may
/// lie outside the shape.
template <class Number>
class LongModes
{
public:
  /// The values at xi, in order of storage, until the next call.
  const std::vector<Number>& operator()(const Space& space, const std::array<Number, 3>& xi)
  {
    const int P = space.order[0];
    const int Q = space.order[1];
    const int R = space.order[2];
    const Number one(1.0L);
    const Number half(0.5L);
    const Number& x1 = xi[0];
    const Number& x2 = xi[1];
    const Number& x3 = xi[2]; // no structured binding: the lambda below captures it
    const Number h3 = half * (one - x3);
    const Number y1 = one + x1 - h3;
    const Number y2 = one + x2 - h3;
    Row a;
    Row b;
    Row c;
    int rowP = -1;
    int rowC = -1;
    Modes.resize(space.Modes());
    const auto quotient = [&](const Number& y)
    { return h3 == Number(0.0L) ? Number(-1.0L) : y / h3; };
    const bool pyramid = space.shape == Shape::Pyramid;
    const bool tetrahedron = space.shape == Shape::Tetrahedron;
    const Number h2 = Number(-0.5L) * (x2 + x3);
    switch (space.shape)
    {
      case Shape::Hexahedron:
        FillScaled(0, P, x1, one, a);
        break;
      case Shape::Prism:
        FillScaled(0, P, y1, h3, a);
        break;
      case Shape::Tetrahedron:
        FillScaled(0, P, one + x1 - h2, h2, a);
        break;
      default:
        FillScaled(0, P, quotient(y1), one, a);
    }
    if (!tetrahedron)
    {
      FillScaled(0, Q, pyramid ? quotient(y2) : x2, one, b);
    }
    ForEachMode(space,
      [&](int p, int q, int r, int mode)
      {
        if (tetrahedron && rowP != p)
        {
          FillScaled(2 * p + 1, Q - p, y2, h3, b);
          rowP = p;
        }
        const auto [alpha, power] = LastFactor(space, p, q);
        if (rowC != alpha)
        {
          FillScaled(alpha, R, x3, one, c);
          rowC = alpha;
        }
        Modes[mode] = a[p] * b[q] * c[r];
        for (int i = 0; i < power; ++i)
        {
          Modes[mode] = Modes[mode] * h3;
        }
      });
    return Modes;
  }

private:
  using Row = std::array<Number, kMaxOrder + 1>;

  /// t^n P_n(y / t) for n = 0 .. last; with t = 1, P_n(y).
  static void FillScaled(int alpha, int last, const Number& y, const Number& t, Row& value)
  {
    const auto* step = RecurrenceTable<long double>::Row(alpha);
    value[0] = Number(1.0L);
    for (int n = 0; n < last; ++n)
    {
      value[n + 1] = (Number(step[n].a) * y + Number(step[n].b) * t) * value[n];
      if (n > 0)
      {
        value[n + 1] = value[n + 1] - Number(step[n].c) * t * t * value[n - 1];
      }
    }
  }

  /// For the mode (p, q, *): alpha of P_r^alpha, and the power of h3 that the other factors lack.
  static std::array<int, 2> LastFactor(const Space& space, int p, int q)
  {
    const int m = std::max(p, q);
    switch (space.shape)
    {
      case Shape::Prism:
        return { 2 * p + 1, 0 };
      case Shape::Tetrahedron:
        return { 2 * p + 2 * q + 2, 0 };
      case Shape::Pyramid:
        return space.form == Form::Collapsed ? std::array{ 2 * m + 2, m } : std::array{ 0, 0 };
      default:
        return { 0, 0 };
    }
  }

  std::vector<Number> Modes;
};
} // namespace pixelexact::testing
