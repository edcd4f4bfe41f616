// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

namespace pixelexact
{
/// An upper bound of |mode (p, q, r)| on the shape.
double ModeBound(const Space& space, int p, int q, int r);
/// The sum of these bounds over all modes.
double SumOfModeBounds(const Space& space);
} // namespace pixelexact
