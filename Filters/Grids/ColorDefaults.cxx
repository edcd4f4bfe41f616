// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/ColorDefaults.h"

#include "Core/Base/Error.h"
#include "Core/Element/MeshRanges.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
namespace
{
using Ends = std::array<double, 2>;

void MakeFirstFieldActive(vtkUnstructuredGrid* grid)
{
  for (const std::string& name : StoredFieldNames(grid))
  {
    if (grid->GetPointData()->SetActiveScalars(name.c_str()) >= 0 ||
      grid->GetCellData()->SetActiveScalars(name.c_str()) >= 0)
    {
      return;
    }
  }
}

vtkDataArray* ArrayOf(vtkUnstructuredGrid* grid, const std::string& field)
{
  vtkDataArray* const array = grid->GetPointData()->GetArray(field.c_str());
  return array != nullptr ? array : grid->GetCellData()->GetArray(field.c_str());
}

/// The proven range of a quantity, which also contains the values of `array`; none without a bound.
std::optional<Ends> RangeWith(
  const Mesh& mesh, const RangeQuestion& question, vtkDataArray* array, int component)
{
  const Interval range = RangeOf(mesh, question, RangeEffort{}).range.outer;
  if (range.IsEmpty() || !range.IsFinite())
  {
    return std::nullopt;
  }
  // Nodal values are rounded, and averages at shared points may differ from the field.
  Ends own;
  array->GetFiniteRange(own.data(), component);
  return own[0] <= own[1] ? Ends{ std::min(own[0], range.lower), std::max(own[1], range.upper) }
                          : Ends{ range.lower, range.upper };
}

/// Stores ranges where VTK keeps those that it computed.
void Keep(vtkDataArray* array, const std::vector<Ends>& components, const std::optional<Ends>& norm)
{
  vtkInformation* const info = array->GetInformation();
  for (vtkInformationInformationVectorKey* const key :
    { vtkAbstractArray::PER_COMPONENT(), vtkAbstractArray::PER_FINITE_COMPONENT() })
  {
    vtkNew<vtkInformationVector> ranges;
    ranges->SetNumberOfInformationObjects(static_cast<int>(components.size()));
    for (std::size_t c = 0; c < components.size(); ++c)
    {
      ranges->GetInformationObject(static_cast<int>(c))
        ->Set(vtkDataArray::COMPONENT_RANGE(), components[c].data(), 2);
    }
    info->Set(key, ranges);
  }
  if (norm)
  {
    info->Set(vtkDataArray::L2_NORM_RANGE(), norm->data(), 2);
    info->Set(vtkDataArray::L2_NORM_FINITE_RANGE(), norm->data(), 2);
  }
}

void StoreRanges(const Mesh& mesh, const Field& field, vtkDataArray* array)
{
  RangeQuestion question;
  question.field = &field;
  std::vector<Ends> components;
  components.reserve(static_cast<std::size_t>(field.values.components));
  for (question.component = 0; question.component < field.values.components; ++question.component)
  {
    const auto range = RangeWith(mesh, question, array, question.component);
    if (!range)
    {
      return;
    }
    components.push_back(*range);
  }
  std::optional<Ends> norm;
  if (field.values.components > 1)
  {
    question.quantity = Quantity::Magnitude;
    question.component = 0;
    norm = RangeWith(mesh, question, array, -1);
  }
  Keep(array, components, norm);
}
} // namespace

void StoreColorDefaults(vtkUnstructuredGrid* grid)
{
  MakeFirstFieldActive(grid);
  if (grid->GetNumberOfCells() == 0)
  {
    return;
  }
  try
  {
    const auto model = HighOrderModel::From(grid);
    for (const Field& field : model->Fields())
    {
      vtkDataArray* const array = ArrayOf(grid, field.name);
      if (array != nullptr && array->GetNumberOfComponents() == field.values.components)
      {
        StoreRanges(model->GetMesh(), field, array);
      }
    }
  }
  catch (const Error&)
  {
    // Whatever draws the grid reports the error.
  }
}
} // namespace pixelexact
