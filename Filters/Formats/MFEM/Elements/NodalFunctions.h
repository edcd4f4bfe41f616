// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/CollectionName.h"

#include "Core/Basis/LineFunctions.h"
#include "Formats/ElementBasis.h"

#include <vector>

// Points on the line and functions of them, from which MFEM's bases are constructed.
namespace pixelexact::mfem
{
/// n points of a line basis in [-1,1], ascending; integrated functions use Gauss's points.
std::vector<long double> LinePoints(LineBasis basis, int n);
/// The functions of a line basis, `count` of them, of order count - 1.
LineFunctions LineOf(LineBasis basis, int count);
/// `count` functions whose integrals over the intervals between count + 1 closed points in [0,1]
/// are one or zero. As in MFEM they are constructed from the derivatives of the points' Lagrange
/// polynomials.
LineFunctions IntegratedOf(LineBasis closed, int count);
/// The functions of a line with the argument -z.
LineFunctions Mirrored(LineFunctions line);
/// The functions of a line times a factor.
LineFunctions Times(long double factor, LineFunctions line);
} // namespace pixelexact::mfem
