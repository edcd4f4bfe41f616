// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContourPolyData_h
#define ContourPolyData_h

#include "PixelExactFiltersModule.h"

#include "Core/Contour/Contour.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace pixelexact
{
class HighOrderModel;

/// Contours as polylines in VTK's data, with the arrays that vtkHighOrderContour names. The
/// vertices' values are in an array of this name. Throws InvalidData where it is another one's.
PIXELEXACTFILTERS_EXPORT void ToPolyData(const ContourSet& set, const HighOrderModel& model,
  const std::string& name, const std::vector<double>& values, vtkPolyData* output);

/// Lines of text about the results, with everything that is undecided or not drawn. The second
/// function returns only the latter; it is empty where everything is certified.
PIXELEXACTFILTERS_EXPORT std::string DescribeContours(const ContourSet& set);
PIXELEXACTFILTERS_EXPORT std::string DescribeDoubts(const ContourReport& report);
} // namespace pixelexact
#endif
