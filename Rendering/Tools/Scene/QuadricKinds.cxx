// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/QuadricKinds.h"

#include <algorithm>

namespace pixelexact
{
const std::array<QuadricKind, 4> kQuadricKinds{ {
  { "--sphere", 4, "cx,cy,cz,r", "a sphere",
    [](const GivenNumbers& p) { return MakeSphere(VectorAt(p, 0), p[3]); } },
  { "--cylinder", 7, "px,py,pz,ax,ay,az,r", "the cylinder about the line through p along a",
    [](const GivenNumbers& p) { return MakeCylinder(VectorAt(p, 0), VectorAt(p, 3), p[6]); } },
  { "--cone", 7, "ax,ay,az,dx,dy,dz,deg",
    "the cone, both halves, with apex a, axis d and so many degrees between axis and surface",
    [](const GivenNumbers& p) { return MakeCone(VectorAt(p, 0), VectorAt(p, 3), p[6]); } },
  { "--quadric", 10, "a0,...,a9",
    "a quadric, in vtkQuadric's order: xx, yy, zz, xy, yz, xz, x, y, z, 1",
    [](const GivenNumbers& p)
    {
      std::array<double, 10> a{};
      std::ranges::copy(p, a.begin());
      return MakeQuadric(a);
    } },
} };
} // namespace pixelexact
