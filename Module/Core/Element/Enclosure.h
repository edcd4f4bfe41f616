// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Mesh.h"

namespace pixelexact
{
struct EnclosureOptions
{
  /// Whether the map may be anything within Mesh::uncertainty of the stored one, as the source's
  /// own map is; false: the stored map, exactly.
  bool meshUncertainty = true;
};

/// Intervals that hold a field's values at world points, the error of the inverse map included.
///
/// `xi` are approximate preimages in `element` of the points `x` (a Locator's); arrays as for the
/// kernels, of PaddedCount(xi.count). Writes `values.lower[c][i]` and `values.upper[c][i]` for
/// component c of the world value (Mapping included) at point i, to arrays of
/// PaddedCount(xi.count).
///
/// What is proven: the stored map Phi, continued beyond the shape as the function that it is, has
/// exactly one preimage of `x[i]` in a small box around `xi[i]`, and the stored field's exact
/// value there lies in the interval. With meshUncertainty, the same of every point within
/// uncertainty[element] of `x[i]` along each axis: whatever map the source had.
///
/// Where nothing can be proven, the interval is everything, -inf to inf: a Jacobian that is
/// singular, or nearly, in the box; a NaN or infinite coefficient; the apex of a pyramid; an xi
/// that is no preimage; a size that is no power of two or outside of 2^-900 to 2^900.
///
/// Method: interval Newton in Krawczyk's form (R. Krawczyk, Newton-Algorithmen zur Bestimmung von
/// Nullstellen mit Fehlerschranken, Computing 4, 1969; S. Rump, Verification methods, Acta Numerica
/// 19, 2010, section 13) with epsilon-inflation, then the mean value form. Assumes rounding to
/// nearest. A point's interval depends on that point, its xi and the element alone.
void EncloseValues(const Mesh& mesh, const Field& field, int element, const LanePoints& xi,
  const LanePoints& x, const BoundArrays& values, const EnclosureOptions& options = {});

/// The same for values and derivatives, `gradients[3 c + d]` of component c by x_d in world units,
/// of a field that has coefficients. Derivatives are those of the stored field by the stored map,
/// at the preimage of any point within the mesh's uncertainty of `x[i]`. Mapped fields get -inf to
/// inf.
void EncloseGradients(const Mesh& mesh, const Field& field, int element, const LanePoints& xi,
  const LanePoints& x, const BoundArrays& values, const BoundArrays& gradients);
} // namespace pixelexact
