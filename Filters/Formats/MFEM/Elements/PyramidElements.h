// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/MFEM/Elements/CollectionName.h"

// H1 and L2 on pyramids.
namespace pixelexact::mfem
{
ElementBasis PyramidBasis(const CollectionName& name);
} // namespace pixelexact::mfem
