// SPDX-License-Identifier: BSD-3-Clause
#include "ShownRange.h"

#include "CompositeParts.h"
#include "HighOrderModel.h"
#include "Views/FieldRange.h"
#include "Views/VtkColorMap.h"

#include "Core/Base/Error.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
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

/// Of the component of an array that a table shows, as ParaView finds it: over all blocks.
ShownRange::Range OfArray(vtkDataObject* data, const std::string& name, vtkScalarsToColors* table)
{
  ShownRange::Range range{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
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

/// Whether a table spans what ParaView makes it span: an array's values.
bool IsAsParaViewSetsIt(vtkDataObject* data, const std::string& field, vtkScalarsToColors* table)
{
  const double* shown = table->GetRange();
  const double tolerance = 1e-6 * (shown[1] - shown[0]);
  try
  {
    const ShownRange::Range range = OfArray(data, field, table);
    return std::fabs(shown[0] - range[0]) <= tolerance &&
      std::fabs(shown[1] - range[1]) <= tolerance;
  }
  catch (const Error&)
  {
    return false; // drawing says what is wrong
  }
}
} // namespace

std::optional<ShownRange::Range> ShownRange::OfField(
  vtkDataObject* data, const std::string& field, vtkScalarsToColors* table)
{
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

std::string ShownRange::Complaint(
  vtkDataObject* data, const std::string& field, vtkScalarsToColors* table)
{
  if (!IsAsParaViewSetsIt(data, field, table))
  {
    return {};
  }
  const std::optional<Range> range = this->OfField(data, field, table);
  const double* shown = table->GetRange();
  if (!range ||
    std::max(shown[0] - (*range)[0], (*range)[1] - shown[1]) <= (shown[1] - shown[0]) / 256.0)
  {
    return {};
  }
  std::ostringstream text;
  text << "the colour map spans the values in the array '" << field << "', " << shown[0] << " to "
       << shown[1] << ", but the field has values from " << (*range)[0] << " to " << (*range)[1]
       << ", and those beyond have the colours of its ends; 'Rescale to Custom Range' shows all";
  return text.str();
}
} // namespace pixelexact
