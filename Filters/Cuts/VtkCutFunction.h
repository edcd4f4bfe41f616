// SPDX-License-Identifier: BSD-3-Clause
#ifndef VtkCutFunction_h
#define VtkCutFunction_h

#include "Core/Contour/CutFunction.h"

#include <memory>
#include <vector>

class vtkImplicitFunction;

namespace pixelexact
{
/// The cut-surface of a vtkImplicitFunction, its transform included. vtkPlane, vtkSphere,
/// vtkCylinder, vtkCone (both halves) and vtkQuadric, moved by an affine transform or not, become
/// copies in closed form; so does a vtkImplicitTorus without a transform whose tube does not pass
/// through itself. Any other function, or transform, is asked itself, by the calling thread
/// alone: callbacks, alone or in booleans, for many points at once (FunctionValues.h). Its gradient
/// is by differences over 1e-6 of `length`, for some of VTK's functions have none (vtkSuperquadric
/// says 0). Where its value is NaN, asking it throws InvalidData, and where a callback fails, Error
/// with its words.
///
/// Throws InvalidData for a surface without points for want of a direction: a plane's normal or an
/// axis of length zero, a radius of a torus that is not positive, a transform without inverse.
std::unique_ptr<const CutFunction> MakeCutFunction(vtkImplicitFunction* function, double length);

/// The planes of a vtkBox or vtkPlanes, with normals that point out of it, moved by an affine
/// transform or not; none of other functions. Throws as MakeCutFunction.
std::vector<QuadricForm> PlanesOf(vtkImplicitFunction* function);
} // namespace pixelexact
#endif
