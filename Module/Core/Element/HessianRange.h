// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Ranges.h"

namespace pixelexact
{
/// The range of  sum over i, j of a_i b_j d^2 F / dx_i dx_j,  F a component of a field as a
/// function of the world point x, over an element or a part of it: the second derivative along a
/// line for a = b of length 1, a mixed one for two vectors. The map's second derivatives are in it,
///
///   d^2 F / dx^2 = J^-T (F'' - sum over c of (dF / dx_c) Phi_c'') J^-1,  '' by xi.
///
/// As RangeOf (Ranges.h), of the stored functions exactly, with the same effort. What is not
/// bounded has infinite ends: where det J may vanish, and next to a pyramid's apex, whose functions
/// are rational. Collapsed edges and vertices of prisms and tetrahedra are regular. Throws
/// Unsupported for mapped fields.
CertifiedRange HessianRange(const Mesh& mesh, int element, const Field& field, int component,
  const Vec3& a, const Vec3& b, const RangeEffort& effort = {}, const Box3& part = kWholeElement);

/// The range of the Frobenius norm of the same matrix. Its upper end bounds the second derivative
/// along every line, and is at most sqrt(3) times the least such bound.
CertifiedRange HessianNormRange(const Mesh& mesh, int element, const Field& field, int component,
  const RangeEffort& effort = {}, const Box3& part = kWholeElement);
} // namespace pixelexact
