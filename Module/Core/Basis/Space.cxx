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
  int modes = 0;
  for (int p = 0; p <= order[0]; ++p)
  {
    for (int q = 0; q <= LastQ(p); ++q)
    {
      modes += LastR(p, q) + 1;
    }
  }
  return modes;
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
