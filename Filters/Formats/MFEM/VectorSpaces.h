// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/CollectionName.h"

#include "Core/Basis/BasisFactor.h"

#include <functional>
#include <vector>

// The polynomial spaces of Nedelec's and Raviart and Thomas's elements, each in a basis of its own.
namespace pixelexact::mfem
{
/// Writes the values of all functions at a point of MFEM's unit element, in its axes.
struct VectorSpace
{
  int count = 0;
  std::function<void(const LongVec3& unit, LongVec3* values)> evaluate;
};

VectorSpace TetrahedronSpace(Continuity kind, int order);
VectorSpace PrismSpace(Continuity kind, int order);
} // namespace pixelexact::mfem
