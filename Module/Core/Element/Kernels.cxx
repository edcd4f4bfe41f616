// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Kernels.h"

namespace pixelexact
{
KernelSet KernelsFor(const Space& space)
{
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return HexahedronKernels(space);
    case Shape::Prism:
      return PrismKernels(space);
    case Shape::Tetrahedron:
      return TetrahedronKernels(space);
    default:
      return space.form == Form::Tensor ? TensorPyramidKernels(space) : PyramidKernels(space);
  }
}
} // namespace pixelexact
