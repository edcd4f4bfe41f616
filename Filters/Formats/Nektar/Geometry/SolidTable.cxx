// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/SolidTable.h"

namespace pixelexact::nektar
{
const SolidTable& TableOf(Shape shape)
{
  static const SolidTable hexahedron{ { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
                                        { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } },
    { { 4, { 0, 1, 2, 3 }, 4 }, { 4, { 0, 1, 5, 4 }, 2 }, { 4, { 1, 2, 6, 5 }, 1 },
      { 4, { 3, 2, 6, 7 }, 3 }, { 4, { 0, 3, 7, 4 }, 0 }, { 4, { 4, 5, 6, 7 }, 5 } },
    { { 0, 1, 4 }, { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 1, 4, 5 }, { 1, 2, 5 }, { 2, 3, 5 },
      { 3, 4, 5 } },
    { 0, 1, 2, 3, 4, 5, 6, 7 } };
  static const SolidTable prism{ { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
                                   { -1, -1, 1 }, { -1, 1, 1 } },
    { { 4, { 0, 1, 2, 3 }, 2 }, { 3, { 0, 1, 4, -1 }, 1 }, { 4, { 1, 2, 5, 4 }, 3 },
      { 3, { 3, 2, 5, -1 }, 0 }, { 4, { 0, 3, 5, 4 }, 4 } },
    { { 0, 1, 4 }, { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 1, 2, 4 }, { 2, 3, 4 } },
    { 3, 2, 5, 0, 1, 4 } };
  static const SolidTable tetrahedron{ { { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 },
                                         { -1, -1, 1 } },
    { { 3, { 0, 1, 2, -1 }, 3 }, { 3, { 0, 1, 3, -1 }, 0 }, { 3, { 1, 2, 3, -1 }, 1 },
      { 3, { 0, 2, 3, -1 }, 2 } },
    { { 0, 1, 3 }, { 0, 1, 2 }, { 0, 2, 3 }, { 1, 2, 3 } }, { 0, 1, 2, 3 } };
  static const SolidTable pyramid{ { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
                                     { -1, -1, 1 } },
    { { 4, { 0, 1, 2, 3 }, 0 }, { 3, { 0, 1, 4, -1 }, 1 }, { 3, { 1, 2, 4, -1 }, 2 },
      { 3, { 3, 2, 4, -1 }, 3 }, { 3, { 0, 3, 4, -1 }, 4 } },
    { { 0, 1, 4 }, { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 1, 3, 3 } }, { 0, 1, 2, 3, 4 } };
  switch (shape)
  {
    case Shape::Hexahedron:
      return hexahedron;
    case Shape::Prism:
      return prism;
    case Shape::Tetrahedron:
      return tetrahedron;
    default:
      return pyramid;
  }
}
} // namespace pixelexact::nektar
