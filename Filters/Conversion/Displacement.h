// SPDX-License-Identifier: BSD-3-Clause
#ifndef Displacement_h
#define Displacement_h

#include "Conversion/WarpRequest.h"
#include "Core/Element/Warp.h"
#include "PixelExactFiltersModule.h"

#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
class HighOrderModel;

/// A displacement of a model's mesh. It refers to fields of the model.
struct Displacement
{
  std::vector<WarpTerm> terms;
  double jump = 0.0; ///< bound of its jumps between elements at the points that were compared
};

/// The displacement of a request, whose scale does not matter here. `grid` is that of the model.
/// It may be a sum of fields with numbers as factors, as a complex field at a phase is. Throws
/// InvalidData for fields that are not there or have the wrong number of components, and
/// Unsupported, with the reason, for other expressions, mapped, rational and discontinuous fields
/// and for displacements out of the plane of a 2-D mesh.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT Displacement DisplacementOf(
  const HighOrderModel& model, vtkUnstructuredGrid* grid, const WarpRequest& request);
} // namespace pixelexact
#endif
