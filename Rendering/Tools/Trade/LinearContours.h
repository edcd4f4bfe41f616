// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Scene.h"

#include <vtkContourFilter.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>

namespace pixelexact
{
/// VTK's contours of a layer's field on triangles that hold it by its name, of the values at their
/// corners: ready to be updated. Null where they do not hold it.
[[nodiscard]] vtkSmartPointer<vtkContourFilter> MakeLinearContours(
  vtkPolyData* surface, const Layer& layer, std::span<const double> isoValues);
} // namespace pixelexact
