// SPDX-License-Identifier: BSD-3-Clause
#include "ShownRange.h"

#include "CompositeParts.h"
#include "HighOrderModel.h"
#include "Trace/Appearance/FieldRange.h"
#include "Views/VtkColorMap.h"

#include "Core/Base/Error.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr ShownRange::Range kNone = { kInfinity, -kInfinity };

std::vector<vtkUnstructuredGrid*> GridsOf(vtkDataObject* data)
{
  std::vector<vtkUnstructuredGrid*> grids;
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    grids.push_back(grid);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    for (const CompositePart& part : PartsOf(composite))
    {
      grids.push_back(part.grid);
    }
  }
  return grids;
}

/// The range of the array's component that a table shows, over all blocks, as in ParaView.
ShownRange::Range OfArray(vtkDataObject* data, const std::string& name, vtkScalarsToColors* table)
{
  ShownRange::Range range = kNone;
  for (vtkUnstructuredGrid* grid : GridsOf(data))
  {
    vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
    array = array != nullptr ? array : grid->GetCellData()->GetArray(name.c_str());
    if (array != nullptr)
    {
      ShownRange::Range own;
      array->GetFiniteRange(own.data(), ComponentOf(table, array->GetNumberOfComponents()));
      range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
    }
  }
  return range;
}

/// The range of an array's values at the cells' points; kNone where there are none.
ShownRange::Range OfValues(vtkDataObject* data, const std::string& field, vtkScalarsToColors* table)
{
  try
  {
    return OfArray(data, field, table);
  }
  catch (const Error&)
  {
    return kNone; // drawing says what is wrong
  }
}

/// The union of all processes' ranges.
ShownRange::Range Joined(const ShownRange::Range& own, vtkMultiProcessController* processes)
{
  if (processes == nullptr)
  {
    return own;
  }
  const double sent[2] = { -own[0], own[1] };
  double most[2] = { 0.0, 0.0 };
  processes->AllReduce(sent, most, 2, vtkCommunicator::MAX_OP);
  return { -most[0], most[1] };
}
} // namespace

std::optional<ShownRange::Range> ShownRange::OfField(
  vtkDataObject* data, const std::string& field, vtkScalarsToColors* table)
{
  if (data == nullptr)
  {
    return std::nullopt;
  }
  try
  {
    const std::shared_ptr<HighOrderModel> model = HighOrderModel::From(data);
    const Field* found = model->FindField(field);
    if (found == nullptr)
    {
      return std::nullopt;
    }
    const int component = ComponentOf(table, found->values.components);
    if (Model != model || Name != field || Component != component)
    {
      Known = FieldRange(model->GetMesh(), *found, component);
      Model = model;
      Name = field;
      Component = component;
    }
    return Known;
  }
  catch (const Error&)
  {
    return std::nullopt; // drawing says what is wrong
  }
}

std::string ShownRange::Complaint(vtkDataObject* data, const std::string& field,
  vtkScalarsToColors* table, vtkMultiProcessController* processes)
{
  const Range values = Joined(OfValues(data, field, table), processes);
  const double* shown = table->GetRange();
  const double tolerance = 1e-6 * (shown[1] - shown[0]);
  // Whether the table spans the range that ParaView sets.
  const bool asSet =
    std::fabs(shown[0] - values[0]) <= tolerance && std::fabs(shown[1] - values[1]) <= tolerance;
  if (processes == nullptr && !asSet)
  {
    return {};
  }
  const Range range = Joined(this->OfField(data, field, table).value_or(kNone), processes);
  this->Whole = range[0] <= range[1] ? std::optional(range) : std::nullopt;
  if (!asSet || !this->Whole ||
    std::max(shown[0] - range[0], range[1] - shown[1]) <= (shown[1] - shown[0]) / 256.0)
  {
    return {};
  }
  std::ostringstream text;
  text << "the colour map spans the values in the array '" << field << "', " << shown[0] << " to "
       << shown[1] << ", but the field's values lie between " << range[0] << " and " << range[1]
       << ", and those beyond have the colours of its ends; 'Rescale to Custom Range' shows all";
  return text.str();
}
} // namespace pixelexact
