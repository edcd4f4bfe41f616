// SPDX-License-Identifier: BSD-3-Clause
#ifndef VtkCutFunction_h
#define VtkCutFunction_h

#include "Core/Contour/CutFunction.h"

#include <memory>
#include <optional>
#include <vector>

class vtkImplicitFunction;

namespace pixelexact
{
/// Returns the polynomial whose zeros are those of a vtkImplicitFunction, its transform included.
/// Supported are vtkPlane, vtkSphere, vtkCylinder, vtkCone (both sides of its apex), vtkQuadric and
/// vtkImplicitTorus. Returns nothing for other functions and for transforms that are not affine.
/// Throws InvalidData for degenerate surfaces: a plane's normal or an axis of length zero, a radius
/// of a torus that is not positive, a transform without inverse.
std::optional<ImplicitPolynomial> PolynomialOf(vtkImplicitFunction* function);

/// Returns the same as patches of surfaces: also vtkBox and vtkPlanes, face by face. None for other
/// functions. Throws as PolynomialOf.
std::vector<SurfacePatch> PatchesOf(vtkImplicitFunction* function);

/// Returns the polynomials of a function that clips where it is positive: PolynomialOf, and the
/// planes of a vtkBox or vtkPlanes. None for other functions. Throws as PolynomialOf.
std::vector<ImplicitPolynomial> ClipsOf(vtkImplicitFunction* function);

/// Returns a cut function of the polynomial (PolynomialOf). Any other function is evaluated
/// directly by the calling thread: callbacks, alone or in booleans, for many points at once
/// (FunctionValues.h). Its gradient is by differences over 1e-6 of `length`, because some of VTK's
/// functions have none (vtkSuperquadric returns 0). Evaluation throws InvalidData where the value
/// is NaN, and Error with the callback's message where a callback fails. Throws as PolynomialOf.
std::unique_ptr<const CutFunction> MakeCutFunction(vtkImplicitFunction* function, double length);
} // namespace pixelexact
#endif
