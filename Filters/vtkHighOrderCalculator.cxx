// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderCalculator.h"

#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderCalculator);

namespace
{
using namespace pixelexact;

/// The field's values at the grid's points.
vtkSmartPointer<vtkDoubleArray> ValuesAtPoints(
  const HighOrderModel& model, const Field& field, vtkUnstructuredGrid* grid)
{
  const vtkIdType count = grid->GetNumberOfPoints();
  std::vector<Vec3> points(static_cast<std::size_t>(count));
  for (vtkIdType p = 0; p < count; ++p)
  {
    grid->GetPoint(p, &points[static_cast<std::size_t>(p)].x);
  }
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(field.values.components);
  array->SetNumberOfTuples(count);
  SampleTarget target;
  target.value = { array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()) };
  Sample(model.GetLocator(), &field, points, target);
  return array;
}
} // namespace

vtkHighOrderCalculator::vtkHighOrderCalculator()
  : MeshFilter(MeshScope::PartByBlock)
{
}

vtkHighOrderCalculator::~vtkHighOrderCalculator() = default;

void vtkHighOrderCalculator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ResultArrayName: " << this->ResultArrayName << "\n";
  os << indent << "Function: " << this->Function << "\n";
  os << indent << "PointValues: " << this->PointValues << "\n";
}

bool vtkHighOrderCalculator::Make(vtkDataObject* mesh, vtkDataObject* output)
{
  const std::string& name = this->ResultArrayName;
  const auto model = this->ModelOf(mesh);
  if (name.empty() || this->Function.empty())
  {
    throw InvalidData(name.empty() ? "the new field has no name; set ResultArrayName."
                                   : "there is no expression; set Function.");
  }
  if (std::ranges::find(model->Fields(), name, &Field::name) != model->Fields().end() ||
    model->Definitions().contains(name))
  {
    throw InvalidData("the grid has a field '" + name + "'; choose another ResultArrayName.");
  }
  const Field& field = model->GetField(this->Function);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(output);
  grid->ShallowCopy(this->Input.GridOf(mesh));
  vtkNew<vtkStringArray> definition;
  definition->SetName((kDefinitionPrefix + name).c_str());
  definition->InsertNextValue(this->Function);
  grid->GetFieldData()->AddArray(definition);
  if (this->PointValues)
  {
    const auto values = ValuesAtPoints(*model, field, grid);
    values->SetName(name.c_str());
    grid->GetPointData()->AddArray(values);
  }
  return true;
}
