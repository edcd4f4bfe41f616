// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

namespace pixelexact
{
/// Kernels dispatched at run time to the instruction set. All of them give the same bits.
struct MappingKernels
{
  /// Turns reference values into world values, in place (see Mapping; not Identity).
  /// `jacobian[3 c + d]` holds d Phi_c / d xi_d in the element's units, `size` is theirs. Arrays of
  /// PaddedCount(count) numbers. Vectors have three components, densities any number.
  void (*toWorld)(Mapping mapping, double size, const double* const* jacobian, int count,
    int components, double* const* value);
};

const MappingKernels& GetMappingKernels();
} // namespace pixelexact
