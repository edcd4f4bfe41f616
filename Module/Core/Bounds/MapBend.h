// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

namespace pixelexact
{
/// How fast the Jacobian of a map may change: InverseProblem::bend, a bound. `coefficients`: three
/// components, in the element's units.
double MapBend(const Space& space, const double* coefficients);
} // namespace pixelexact
