// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

#include "Core/Basis/Recurrence.h"

#include <array>

namespace pixelexact::testing
{
/// Phi of the stored coefficients in long double (64 bits of mantissa): 2,000 times finer than what
/// is tested with it. Right beyond the shape too, where a point may lie by its face's tolerance.
class LongMap
{
public:
  explicit LongMap(const Mesh& mesh)
    : Elements(mesh)
  {
  }

  [[nodiscard]] LongVec3 operator()(int element, const LongVec3& xi)
  {
    const Space& space = Elements.map.SpaceOf(element);
    FillModes(space, xi);
    const double* coefficient = Elements.map.Coefficients(element);
    LongVec3 x{};
    for (int d = 0; d < 3; ++d)
    {
      for (const long double mode : Modes)
      {
        x[d] += *coefficient++ * mode;
      }
      x[d] = Elements.centre[3 * static_cast<std::size_t>(element) + d] +
        x[d] * static_cast<long double>(Elements.size[element]);
    }
    return x;
  }

  /// The columns dPhi / dxi_j in world units, where Phi is `at` that: to some 1e-8, by differences.
  [[nodiscard]] std::array<LongVec3, 3> Columns(int element, const LongVec3& xi, const LongVec3& at)
  {
    // Small against the distance to a pyramid's apex, where the functions are rational.
    constexpr long double kStep = 0x1p-34L;
    std::array<LongVec3, 3> columns;
    for (int j = 0; j < 3; ++j)
    {
      LongVec3 next = xi;
      next[j] += kStep;
      columns[j] = Times(1.0L / kStep, Minus((*this)(element, next), at));
    }
    return columns;
  }

private:
  using Row = std::array<long double, kMaxOrder + 1>;

  /// t^n P_n(y / t) for n = 0 .. last; with t = 1, P_n(y).
  static void FillScaled(int alpha, int last, long double y, long double t, Row& value)
  {
    const auto* step = RecurrenceTable<long double>::Row(alpha);
    value[0] = 1.0L;
    for (int n = 0; n < last; ++n)
    {
      value[n + 1] = (step[n].a * y + step[n].b * t) * value[n] -
        (n > 0 ? step[n].c * t * t * value[n - 1] : 0.0L);
    }
  }

  void FillModes(const Space& space, const LongVec3& xi)
  {
    const int P = space.order[0];
    const int Q = space.order[1];
    const int R = space.order[2];
    const long double x1 = xi[0];
    const long double x2 = xi[1];
    const long double x3 = xi[2];
    const long double h3 = (1 - x3) / 2;
    const long double y1 = 1 + x1 - h3;
    const long double y2 = 1 + x2 - h3;
    Row a;
    Row b;
    Row c;
    int rowP = -1;
    int rowC = -1;
    Modes.resize(space.Modes());
    const auto quotient = [&](long double y) { return h3 == 0.0L ? -1.0L : y / h3; };
    const bool pyramid = space.shape == Shape::Pyramid;
    const bool tetrahedron = space.shape == Shape::Tetrahedron;
    const long double h2 = -(x2 + x3) / 2;
    switch (space.shape)
    {
      case Shape::Hexahedron:
        FillScaled(0, P, x1, 1.0L, a);
        break;
      case Shape::Prism:
        FillScaled(0, P, y1, h3, a);
        break;
      case Shape::Tetrahedron:
        FillScaled(0, P, 1 + x1 - h2, h2, a);
        break;
      default:
        FillScaled(0, P, quotient(y1), 1.0L, a);
    }
    if (!tetrahedron)
    {
      FillScaled(0, Q, pyramid ? quotient(y2) : x2, 1.0L, b);
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
          FillScaled(alpha, R, x3, 1.0L, c);
          rowC = alpha;
        }
        Modes[mode] = a[p] * b[q] * c[r];
        for (int i = 0; i < power; ++i)
        {
          Modes[mode] *= h3;
        }
      });
  }

  /// Of the mode (p, q, *): alpha of P_r^alpha, and the power of h3 not yet in the other factors.
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

  Mesh Elements;
  std::vector<long double> Modes;
};
} // namespace pixelexact::testing
