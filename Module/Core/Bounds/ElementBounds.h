// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bounds/InverseGuess.h"
#include "Core/Bounds/MapCurvature.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"

#include <limits>

namespace pixelexact
{
/// Bounds of an element's map that are independent of points, all certified by Bernstein
/// hulls with their rounding errors.
///
/// In the element's units y = (x - centre) / size, the frame is the affine map with the inverse
/// Jacobian A^-1 at the shape's centre xi_c, and
///   D(xi) = A^-1 (Phi(xi) - Phi(xi_c)) + xi_c - xi
/// its deviation. Every preimage xi of y lies in  xi_0 - [lower, upper],
/// xi_0 = A^-1 (y - Phi(xi_c)) + xi_c.
struct ElementBounds
{
  Box3 box;               ///< of the element's image, widened by its uncertainty
  double origin[3] = {};  ///< Phi(xi_c)
  double inverse[9] = {}; ///< A^-1, row-major
  double lower[3] = {};   ///< of the deviation, rounding included
  double upper[3] = {};
  double uncertainty[3] = {}; ///< of Phi and y together, in the element's units
  /// Phi is injective on the shape enlarged until Margin = -injectiveMargin: a root found there,
  /// outside of the shape, proves that the shape holds none. 0: not known.
  double injectiveMargin = 0.0;
  double curvature = kUnknownCurvature;                  ///< see InverseProblem
  double bend = std::numeric_limits<double>::infinity(); ///< see InverseProblem
  InverseGuess guess;
  bool framed = false; ///< the Jacobian at the centre can be inverted
  bool affine = false; ///< the deviation is of rounding size
};

/// Computes the box alone, also certified, with a bound of its coefficients' rounding that takes
/// less time.
Box3 MakeElementBox(const Mesh& mesh, int element);

/// Bounds the distance between an evaluated image of the element and the true one, per coordinate,
/// in world units: the mesh's uncertainty, the rounding of coordinates and of the evaluation.
Vec3 ImageUncertainty(const Mesh& mesh, int element);

/// The bounds of one element of a valid mesh.
ElementBounds MakeElementBounds(const Mesh& mesh, int element);

/// The Newton kernel's view of an element, which refers to the bounds.
InverseProblem MakeInverseProblem(const Mesh& mesh, int element, const ElementBounds& bounds);
} // namespace pixelexact
