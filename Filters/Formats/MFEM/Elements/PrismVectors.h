// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/MFEM/Elements/VectorUnknowns.h"

namespace pixelexact::mfem
{
/// The functions that are dual to the unknowns of a prism, as products of triangle and line.
ElementBasis PrismVectors(const CollectionName& name, const std::vector<VectorUnknown>& unknowns);
} // namespace pixelexact::mfem
