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
/// The polynomial whose zeros are those of a vtkImplicitFunction, its transform included: of
/// vtkPlane, vtkSphere, vtkCylinder, vtkCone (both halves), vtkQuadric and vtkImplicitTorus.
/// Nothing for other functions, and for transforms that are not affine.
///
/// Throws InvalidData for a surface without points for want of a direction: a plane's normal or an
/// axis of length zero, a radius of a torus that is not positive, a transform without inverse.
std::optional<ImplicitPolynomial> PolynomialOf(vtkImplicitFunction* function);

/// The same as parts of surfaces: also vtkBox and vtkPlanes, face by face. None for other
/// functions. Throws as PolynomialOf.
std::vector<SurfacePatch> PatchesOf(vtkImplicitFunction* function);

/// What clips, where it is positive: PolynomialOf, and the planes of a vtkBox or vtkPlanes. None
/// for other functions. Throws as PolynomialOf.
std::vector<ImplicitPolynomial> ClipsOf(vtkImplicitFunction* function);

/// PolynomialOf as a copy. Any other function is evaluated itself, by the calling thread alone:
/// callbacks, alone or in booleans, for many points at once (FunctionValues.h). Its gradient is by
/// differences over 1e-6 of `length`, for some of VTK's functions have none (vtkSuperquadric says
/// 0). Where its value is NaN, evaluating it throws InvalidData, and where a callback fails, Error
/// with its words. Throws as PolynomialOf.
std::unique_ptr<const CutFunction> MakeCutFunction(vtkImplicitFunction* function, double length);
} // namespace pixelexact
#endif
