// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Math/Vec.h"

#include <functional>
#include <span>

namespace pixelexact
{
/// Values of a function at points of a box, all at once.
using SampledFunction = std::function<void(std::span<const Vec3> eta, std::span<double> values)>;

/// The polynomial of this degree in each direction that has the function's values at the box's
/// Chebyshev points. Its error is not known; `error` is 0.
BoxPolynomial SamplePolynomial(int degree, const Box3& box, const SampledFunction& function);
} // namespace pixelexact
