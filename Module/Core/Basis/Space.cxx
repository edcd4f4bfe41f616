// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/Space.h"

#include <algorithm>

namespace pixelexact
{
int Space::MaxOrder() const
{
  return std::max({ order[0], order[1], order[2] });
}

int Space::LastQ(int p) const
{
  return shape == Shape::Tetrahedron ? order[1] - p : order[1];
}

int Space::LastR(int p, int q) const
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return order[2];
    case Shape::Prism:
      return order[2] - p;
    case Shape::Tetrahedron:
      return order[2] - p - q;
    default:
      return form == Form::Tensor ? order[2] : order[2] - std::max(p, q);
  }
}

int Space::Modes() const
{
  // Asked for every batch: sums over r, and over q where that is easy, in closed form.
  const auto [P, Q, R] = order;
  switch (shape)
  {
    case Shape::Hexahedron:
      return (P + 1) * (Q + 1) * (R + 1);
    case Shape::Prism:
      return (Q + 1) * ((P + 1) * (R + 1) - P * (P + 1) / 2);
    case Shape::Tetrahedron:
    {
      int modes = 0;
      for (int p = 0; p <= P; ++p)
      {
        const int n = Q - p + 1;
        modes += n * (R - p + 1) - n * (n - 1) / 2;
      }
      return modes;
    }
    default:
    {
      if (form == Form::Tensor)
      {
        return (P + 1) * (Q + 1) * (R + 1);
      }
      int modes = 0;
      for (int m = 0; m <= std::max(P, Q); ++m)
      {
        // Pairs (p, q) whose larger one is m.
        const int upTo = std::min<int>(m, P) + 1;
        const int across = std::min<int>(m, Q) + 1;
        const int below = std::min<int>(m - 1, P) + 1;
        const int belowAcross = std::min<int>(m - 1, Q) + 1;
        modes += (upTo * across - below * belowAcross) * (R - m + 1);
      }
      return modes;
    }
  }
}

std::array<int, 3> Space::TensorDegree() const
{
  // h^n P_k with n + k <= R has degree at most R, so the orders are the degrees in every form.
  return { order[0], order[1], order[2] };
}

bool Space::IsValid() const
{
  if (!IsShape(static_cast<int>(shape)) || MaxOrder() > kMaxOrder)
  {
    return false;
  }
  const auto [p, q, r] = order;
  switch (shape)
  {
    case Shape::Hexahedron:
      return form == Form::Collapsed;
    case Shape::Prism:
      return form == Form::Collapsed && p <= r;
    case Shape::Tetrahedron:
      return form == Form::Collapsed && p <= q && q <= r;
    default:
      return form == Form::Tensor || (form == Form::Collapsed && std::max(p, q) <= r);
  }
}

Space UniformSpace(Shape shape, int order)
{
  const auto n = static_cast<std::uint8_t>(order);
  return { shape, Form::Collapsed, { n, n, n } };
}
} // namespace pixelexact
