// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/MFEM/Elements/CollectionName.h"

// Nedelec's and Raviart and Thomas's elements.
namespace pixelexact::mfem
{
ElementBasis VectorBasis(const CollectionName& name, Geometry solid);
} // namespace pixelexact::mfem
