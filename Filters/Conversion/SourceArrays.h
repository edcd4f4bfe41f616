// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceArrays_h
#define SourceArrays_h

#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// The numeric arrays that make fields.
struct FieldArrays
{
  std::vector<vtkDataArray*> points;
  std::vector<vtkDataArray*> cells;
};

/// All numeric arrays, or those of the given names, of PointData, then of CellData; where both have
/// a name, that of PointData. Left out unless named: ids, ghost flags, weights and degrees. Throws
/// InvalidData for a name that is not there.
FieldArrays SelectFields(vtkUnstructuredGrid* grid, const std::vector<std::string>& names);
} // namespace pixelexact
#endif
