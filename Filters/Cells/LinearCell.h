// SPDX-License-Identifier: BSD-3-Clause
#ifndef LinearCell_h
#define LinearCell_h

#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <vector>

namespace pixelexact
{
/// VTK's linear cell of a shape.
struct LinearCell
{
  int type = 0;
  std::vector<Vec3> corners; ///< in xi, in VTK's order
  std::vector<int> faceOf;   ///< per face of VTK's, its number in FacesOf(shape)
};

const LinearCell& LinearCellOf(Shape shape);
} // namespace pixelexact
#endif
