// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FaceNumbers.h"

#include "Core/Shape/ShapeFace.h"

namespace pixelexact
{
FaceNumbers::FaceNumbers(const Mesh& mesh)
  : First(static_cast<std::size_t>(mesh.Elements()) + 1)
{
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const auto at = static_cast<std::size_t>(e);
    First[at + 1] = First[at] + FacesOf(mesh.ShapeOf(e)).size();
  }
}
} // namespace pixelexact
