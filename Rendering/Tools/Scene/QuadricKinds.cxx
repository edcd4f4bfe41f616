// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/QuadricKinds.h"

#include <algorithm>

namespace pixelexact
{
const std::array<QuadricKind, 4> kQuadricKinds{ {
  { "--sphere", [](const GivenNumbers& p) { return MakeSphere(VectorAt(p, 0), p[3]); } },
  { "--cylinder",
    [](const GivenNumbers& p) { return MakeCylinder(VectorAt(p, 0), VectorAt(p, 3), p[6]); } },
  { "--cone",
    [](const GivenNumbers& p) { return MakeCone(VectorAt(p, 0), VectorAt(p, 3), p[6]); } },
  { "--quadric",
    [](const GivenNumbers& p)
    {
      std::array<double, 10> a{};
      std::ranges::copy(p, a.begin());
      return MakeQuadric(a);
    } },
} };
} // namespace pixelexact
