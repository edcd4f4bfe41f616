// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

namespace pixelexact
{
/// Computes InverseProblem::bend, a bound of the change of a map's Jacobian. `coefficients`: three
/// components, in the element's units.
double MapBend(const Space& space, const double* coefficients);
} // namespace pixelexact
