// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/SourceArrays.h"

#include "Conversion/SourceMesh.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "PackedArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <set>

namespace pixelexact
{
namespace
{
class Selection
{
public:
  Selection(const std::vector<std::string>& names)
    : Names(names.begin(), names.end())
  {
  }

  std::vector<vtkDataArray*> From(vtkDataSetAttributes* data)
  {
    std::vector<vtkDataArray*> chosen;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i); // null where not numeric
      const std::string name = array && array->GetName() ? array->GetName() : "";
      if (!name.empty() && array->GetNumberOfComponents() > 0 && Wanted(data, array, name) &&
        Taken.insert(name).second)
      {
        chosen.push_back(array);
      }
    }
    return chosen;
  }

  void RequireAll(vtkUnstructuredGrid* grid) const
  {
    for (const auto& name : Names)
    {
      if (!Taken.contains(name))
      {
        std::string known;
        for (vtkDataSetAttributes* data :
          { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
            static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
        {
          for (int i = 0; i < data->GetNumberOfArrays(); ++i)
          {
            known += std::string(known.empty() ? "" : ", ") +
              (data->GetArrayName(i) ? data->GetArrayName(i) : "");
          }
        }
        throw InvalidData("the grid has no numeric array '" + name +
          "'; it has: " + (known.empty() ? "none" : known) + ".");
      }
    }
  }

private:
  [[nodiscard]] bool Wanted(
    vtkDataSetAttributes* data, vtkDataArray* array, const std::string& name) const
  {
    if (!Names.empty())
    {
      return Names.contains(name);
    }
    static const std::set<std::string> bookkeeping{ vtkDataSetAttributes::GhostArrayName(),
      "vtkOriginalPointIds", "vtkOriginalCellIds", "RationalWeights", "HigherOrderDegrees",
      kElementIds, kSourceCells, kInnerFaces, kLinearizedOrder };
    return !bookkeeping.contains(name) && !name.starts_with(kPackedPrefix) &&
      array != data->GetGlobalIds() && array != data->GetPedigreeIds() &&
      array != data->GetRationalWeights() && array != data->GetHigherOrderDegrees();
  }

  std::set<std::string> Names;
  std::set<std::string> Taken;
};
} // namespace

FieldArrays SelectFields(vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  Selection selection(names);
  FieldArrays fields;
  fields.points = selection.From(grid->GetPointData());
  fields.cells = selection.From(grid->GetCellData());
  selection.RequireAll(grid);
  return fields;
}
} // namespace pixelexact
