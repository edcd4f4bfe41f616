// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/CutGraph.h"
#include "Core/Integral/Integrand.h"

#include <optional>

namespace pixelexact
{
/// An integral over a graph, and along which of its directions more terms would gain most.
struct GraphSums
{
  Sums sums;
  std::vector<double> magnitudes; ///< about the integrals of the magnitudes
  int roughest = 0;               ///< a direction of eta
  bool anyRange = false;          ///< of the integrands: see IsRange
};

/// The integrals over a graph; none where its models do not converge on so large a box, or the sign
/// of det J is not proven.
///
/// With S the cut-surface's function and g its polynomial in eta, the surface is eta_c = h(eta_a,
/// eta_b) and
///   n dS = grad S |det J| / |dg / deta_c| deta_a deta_b
/// by the implicit function theorem; det J by eta is that by xi times the collapse of the shape.
/// h is Newton's iteration on models, and where |g| <= rho on it and |dg / deta_c| >= m all about
/// it, off by at most rho / m. The integral of a model is that of its terms.
std::optional<GraphSums> Integrate(ElementFunctions& functions, const CutGraph& graph);

/// The field over a parametrised surface in an element, on (s, t) in [-1,1]^2.
struct SurfaceValues
{
  std::vector<ChebyshevModel> values; ///< by component, in world units
  std::array<ChebyshevModel, 3> eta;  ///< the place
  std::vector<ChebyshevModel> clips;  ///< what counts is where none of them is positive
  std::array<int, 2> axes{};          ///< the directions of eta along s and t
};
/// On a graph; none as above, but for the sign of det J.
std::optional<SurfaceValues> ValuesOn(ElementFunctions& functions, const CutGraph& graph);
/// On a face of an element, number `face` of FacesOf(shape), over a box in it, whose ends along the
/// face's direction are the face's.
SurfaceValues ValuesOnFace(ElementFunctions& functions, int face, const PieceBox& box);
} // namespace pixelexact
