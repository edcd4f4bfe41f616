// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/Nektar/Fields/FieldFile.h"

#include <functional>

namespace pixelexact::nektar
{
/// The basis of an expansion. Throws Unsupported for families that are not read, InvalidData for
/// orders that its shape does not allow.
ElementBasis MakeFieldBasis(const Expansion3& expansion);

/// Functions on a shape, in the smallest canonical space that holds them: orders `order`, on
/// pyramids the collapsed form if it will do, otherwise the tensor form.
ChangeOfBasis ChangeInto(Shape shape, const std::array<int, 3>& order, int functions,
  const std::function<void(const LongVec3&, long double*)>& evaluate);
} // namespace pixelexact::nektar
