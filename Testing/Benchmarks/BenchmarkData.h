// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HighOrderModel.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include "Trace/Camera.h"
#include "Trace/Frame.h"

#include <memory>

namespace pixelexact::benchmarks
{
/// A data set with its plane cut: what every benchmark of a set starts from. Made once.
struct PlaneCut
{
  const char* name;
  vtkSmartPointer<vtkUnstructuredGrid> source; ///< as VTK's own filters get it
  std::shared_ptr<HighOrderModel> model;
  const Field* field;
  Vec3 origin;
  Vec3 normal;
  Frame frame;                ///< 1000 x 1000: Value, Position, Xi, Verdict
  std::vector<Vec3> inside;   ///< positions of its exact pixels, pixel by pixel
  std::vector<double> values; ///< and the values there
};

/// 0: Data/toroid_hex_g3_p6.vtu (48 curved hexahedra, field order 6).
/// 1: 21,952 curved hexahedra of order 3 with a field of order 3, made here.
/// The camera looks along the normal and the cut fills most of the image.
const PlaneCut& GetPlaneCut(int set);

/// A camera of `pixels` x `pixels` that shows a whole set along its plane's normal.
Camera ViewOf(const PlaneCut& cut, int pixels);

/// Every `stride`-th of the cut's inside points.
vtkSmartPointer<vtkPolyData> PointsOf(const PlaneCut& cut, std::size_t stride);
} // namespace pixelexact::benchmarks
