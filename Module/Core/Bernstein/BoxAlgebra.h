// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"

// Sums, products and derivatives of polynomials over one box. Errors include those of rounding.
namespace pixelexact
{
/// f g, of the degrees' sum.
BoxPolynomial Multiply(const BoxPolynomial& f, const BoxPolynomial& g);

/// a f + b g, where both have the same degrees.
BoxPolynomial Combine(double a, const BoxPolynomial& f, double b, const BoxPolynomial& g);

/// f + g of any degrees.
BoxPolynomial Sum(const BoxPolynomial& f, const BoxPolynomial& g);

/// The derivative along a direction, by a coordinate that is 0 at the box's lower and 1 at its
/// upper end, in f's own degrees.
BoxPolynomial Derivative(const BoxPolynomial& f, int direction);

/// f + c for every number c of the interval.
void Add(const Interval& c, BoxPolynomial& f);
} // namespace pixelexact
