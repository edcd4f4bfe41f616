// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Scene.h"

#include <vtkContourFilter.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkImplicitFunction;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// The integral by VTK's filters: elements subdivided into linear cells (vtkHighOrderSubdivide,
/// level 0 to 5), vtkCutter, vtkIntegrateAttributes.
struct LinearIntegral
{
  double area = 0.0;
  std::vector<double> integrals; ///< of the field's components
  std::int64_t triangles = 0;
};
/// `field` may be empty for none. Throws Error with VTK's message.
LinearIntegral IntegrateLinearly(
  vtkUnstructuredGrid* grid, vtkImplicitFunction* function, const std::string& field, int level);

/// VTK's contours of a layer's field on triangles that hold it by its name, of the values at their
/// corners: ready to be updated. Null where they do not hold it.
[[nodiscard]] vtkSmartPointer<vtkContourFilter> MakeLinearContours(
  vtkPolyData* surface, const Layer& layer, std::span<const double> isoValues);
} // namespace pixelexact
